import { SlidersHorizontal } from 'lucide-react';
import { memo, useDeferredValue } from 'react';
import { type LevelFile, RULE_NAMES, RULES, type RuleName } from '../../../schema/index.ts';
import { type Editor, perLevel, useDocument, useSelectedKeys } from '../../core/context/index.ts';
import { type FoundObject, type ObjectKey, objectsOf, resetRules, titled } from '../../core/document/index.ts';
import type { Feature } from '../feature.ts';
import { LevelFields } from './LevelFields.tsx';
import { ObjectFields } from './ObjectFields.tsx';
import './inspector.css';
import type { Command, Destination } from '../../core/commands/index.ts';
import { folderTermsIn } from '../../core/files/index.ts';
import { ruleLabel, ruleValues } from './index.ts';

/** The numbers of what is selected, or of the level and its rules. */
export const inspector: Feature = {
  name: 'inspector',
  panel: {
    id: 'inspector',
    title: 'Inspector',
    icon: <SlidersHorizontal size={17} />,
    side: 'right',
    place: 'tab',
    content: perLevel(Inspector),
  },
  commands: ruleCommands,
  destinations: ruleDestinations,
};

/** The fields of the selection: one object, what several objects have in common, or the level itself. */
function Inspector() {
  // A marquee changes the selection with every move of the pointer: the canvas has priority.
  const keys = useDeferredValue(useSelectedKeys());
  const file = useDocument((state) => state.file);
  return <Fields keys={keys} file={file} />;
}

const Fields = memo(function Fields({ keys, file }: { readonly keys: readonly ObjectKey[]; readonly file: LevelFile }) {
  const objects = keys.flatMap((key): FoundObject[] => {
    const found = objectsOf(file).get(key);
    return found === undefined ? [] : [found];
  });
  return (
    <div className="panel__body inspector">
      {/* Keyed by the selection, so that nothing typed for one object ends up in another. */}
      {objects.length === 0 ? <LevelFields file={file} /> : <ObjectFields key={keys.join()} keys={keys} objects={objects} />}
    </div>
  );
});

/** Shows the rules of the open level and focuses one of them. */
function goToRule(editor: Editor, name: RuleName): void {
  // With nothing selected, the inspector shows the level, which has the rules.
  editor.open.getState()?.selection.clear();
  editor.commands.run('panel.inspector');
  editor.session.setState({ askedRule: name });
}

/** Commands for the rules of the open level. */
function ruleCommands(editor: Editor): readonly Command[] {
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
function ruleDestinations(editor: Editor): readonly Destination[] {
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
