import { RULE_NAMES, RULES, type RuleName } from '../../../schema/index.ts';
import type { Command, Destination } from '../../core/commands/index.ts';
import type { Editor } from '../../core/context/index.ts';
import { resetRules, titled } from '../../core/document/index.ts';
import { folderTermsIn } from '../../core/files/index.ts';
import { ruleLabel, ruleValues } from './rule-values.ts';

/** Shows the rules of the open level and focuses one of them. */
function goToRule(editor: Editor, name: RuleName): void {
  // With nothing selected, the inspector shows the level, which has the rules.
  editor.open.getState()?.selection.clear();
  editor.commands.run('panel.inspector');
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

/** The rules of the open level. */
export function ruleDestinations(editor: Editor): readonly Destination[] {
  const file = editor.open.getState()?.document.file();
  if (file === undefined) return [];
  return ruleValues(file, folderTermsIn(editor.workspace.store.getState())).map(({ name, value }) => ({
    key: `rule ${name}`,
    group: 'Rule',
    title: titled(ruleLabel(name)),
    detail: `${value} ${RULES[name].unit}`,
    go: () => goToRule(editor, name),
  }));
}
