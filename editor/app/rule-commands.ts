import { RULE_NAMES, type RuleName } from '../../schema/index.ts';
import type { Command } from '../core/commands/index.ts';
import type { Editor } from '../core/context/index.ts';
import { resetRules } from '../core/document/index.ts';
import { showPanel } from './show-panel.ts';

/** Shows the rules of the open level and focuses one of them. */
export function goToRule(editor: Editor, name: RuleName): void {
  // With nothing selected, the inspector shows the level, which has the rules.
  editor.open.getState()?.selection.clear();
  showPanel(editor, 'inspector');
  editor.session.setState({ askedRule: name });
}

/** Commands for the rules of the open level. */
export function ruleCommands(editor: Editor): readonly Command[] {
  const { open } = editor;
  const needsLevel = () => (open.getState() === null ? 'open a level first' : null);
  const hasRules = () => RULE_NAMES.some((name) => open.getState()?.document.file().rules?.[name] !== undefined);
  return [
    { id: 'rules.go', title: 'Go to rules', group: 'View', needs: needsLevel, run: () => goToRule(editor, RULE_NAMES[0]) },
    {
      id: 'rules.reset',
      title: "Reset the level's rules",
      group: 'Edit',
      needs: () => needsLevel() ?? (hasRules() ? null : 'the level changes no rule'),
      run: () => void open.getState()?.document.change('Reset the rules of the level', resetRules),
    },
  ];
}
