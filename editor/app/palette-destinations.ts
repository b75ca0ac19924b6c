import { RULES } from '../../schema/index.ts';
import type { Editor } from '../core/context/index.ts';
import { nameOf, titled } from '../core/document/index.ts';
import { folderTermsIn } from '../core/files/index.ts';
import { openListed } from '../core/levels/index.ts';
import { comparedOf, compareOrTell, isCompared } from '../features/compare/index.ts';
import { ruleLabel, ruleValues } from '../features/inspector/index.ts';
import { objectRows } from '../features/outliner/index.ts';
import { goToRule } from './rule-commands.ts';

/** A level, run, object or rule that the palette can go to. */
export interface Destination {
  /** unique */
  readonly key: string;
  readonly group: 'Level' | 'Run' | 'Object' | 'Rule';
  readonly title: string;
  /** Distinguishes it from others of the same name. */
  readonly detail: string;
  readonly go: () => void;
}

/** At most this many of a group are listed; another typed letter narrows the list. */
const MOST = 12;

/** Destinations that contain every word of the query; none while the query is empty. */
export function findDestinations(editor: Editor, query: string): readonly Destination[] {
  const words = query.toLowerCase().split(/\s+/).filter(Boolean);
  if (words.length === 0) return [];
  const matching = (destinations: readonly Destination[]) =>
    destinations
      .filter(({ group, title, detail }) => {
        const text = `${group} ${title} ${detail}`.toLowerCase();
        return words.every((word) => text.includes(word));
      })
      .slice(0, MOST);
  return [levels, runs, comparable, objects, rules].flatMap((list) => matching(list(editor)));
}

function levels(editor: Editor): Destination[] {
  const { list, opened } = editor.workspace.store.getState();
  return (list?.levels ?? [])
    .filter(({ id, status }) => status === 'valid' && id !== opened?.id())
    .map(({ id, name }) => ({
      key: `level ${id}`,
      group: 'Level',
      title: name ?? id,
      detail: id,
      go: () => void openListed(editor, id),
    }));
}

function rules(editor: Editor): Destination[] {
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

function runs({ open, session }: Editor): Destination[] {
  return (open.getState()?.document.file().runs ?? []).map(({ name, holds }) => ({
    key: `run ${name}`,
    group: 'Run',
    title: name,
    detail: `${holds.length} ${holds.length === 1 ? 'hold' : 'holds'}`,
    go: () => session.setState({ run: name }),
  }));
}

function comparable(editor: Editor): Destination[] {
  const level = editor.open.getState();
  if (level === null) return [];
  const shown = level.proof.proof().run.name;
  return (level.document.file().runs ?? [])
    .filter(({ name }) => name !== shown)
    .map(({ name }) => {
      const source = { kind: 'run', name } as const;
      const isIn = isCompared(comparedOf(level).getState(), source);
      return {
        key: `compare ${name}`,
        group: 'Run',
        title: `${isIn ? 'Stop comparing' : 'Compare with'} ${name}`,
        detail: '',
        go: () => compareOrTell(editor, level, source),
      };
    });
}

function objects({ open, commands }: Editor): Destination[] {
  const level = open.getState();
  if (level === null) return [];
  return objectRows(level.document.file(), new Set()).flatMap(({ found, title, key }): Destination[] => {
    if (found === null) return [];
    const { x, y } = found.object;
    return [
      {
        key: `object ${key}`,
        group: 'Object',
        title,
        detail: `${title === nameOf(found) ? '' : `${nameOf(found).toLowerCase()}, `}${found.list === null ? '' : `${key}, `}at ${Math.round(x)}, ${Math.round(y)}`,
        go: () => {
          level.selection.select([key]);
          commands.run('view.fit-selection');
        },
      },
    ];
  });
}
