import { takeBack } from '../../../review/index.ts';
import type { LevelFile } from '../../../schema/index.ts';
import type { Editor, OpenLevel } from '../../core/context/index.ts';
import { nameOf, objectsOf } from '../../core/document/index.ts';
import { folderOf } from '../../core/files/index.ts';
import { addLevels, copyOf } from '../../core/levels/index.ts';
import type { DifferencePart } from './use-comparison.ts';

/** What was done; or why not, and nothing has changed. */
export type Restored = { readonly ok: true } | { readonly ok: false; readonly why: string };

const refused = (why: string): Restored => ({ ok: false, why });

/** Why the level can't be changed at this moment; null: it can. */
export function whyNot({ opened, document }: Pick<OpenLevel, 'opened' | 'document'>): string | null {
  if (opened.lock.store.getState() !== 'writer') return 'Another tab has this level open. Take over there first.';
  if (document.file() !== document.committedFile()) return 'Something is being dragged. Let go of it first.';
  return null;
}

function replaced(level: OpenLevel, label: string, file: LevelFile): Restored {
  // so that what is left is in the history, too, even if it was not on disk yet
  level.opened.versions.note(level.document.committedFile(), 'page');
  const result = level.document.replace(label, file);
  return result.ok ? { ok: true } : refused(`${result.refusal.message}. ${result.refusal.hint}`);
}

/** Replaces the level by a version, as one step. @param when the time of the version, for the label of the step */
export function restoreVersion(level: OpenLevel, file: LevelFile, when: string): Restored {
  const why = whyNot(level);
  return why === null ? replaced(level, `Restore version of ${when}`, file) : refused(why);
}

/** Why an object can't come back with its id; null if every one can. */
function takenId(now: LevelFile, parts: readonly DifferencePart[]): string | null {
  const gone = new Set(parts.flatMap(({ change }) => (change.type === 'added' ? [change.entry.id] : [])));
  for (const { change } of parts) {
    if (change.type !== 'removed' || change.of === 'runs' || typeof change.entry.id !== 'string') continue;
    const owner = objectsOf(now).get(change.entry.id);
    if (owner !== undefined && !gone.has(owner.key)) return `the id ${owner.key} belongs to ${nameOf(owner)} now`;
  }
  return null;
}

/**
 * Takes differences back, as one step; the rest of the level stays as it is.
 * @param before the version that the differences lead from
 * @param after the version that they lead to: the present one
 */
export function takeBackParts(level: OpenLevel, before: LevelFile, after: LevelFile, parts: readonly DifferencePart[]): Restored {
  const why = whyNot(level);
  if (why !== null) return refused(why);
  const now = level.document.file();
  if (now !== after) return refused('The level has changed in the meantime. Choose again.');
  const taken = takenId(now, parts);
  if (taken !== null) return refused(`It can't come back: ${taken}. Restore the whole version instead.`);
  let file: LevelFile;
  try {
    file = takeBack(
      before,
      now,
      parts.map(({ change }) => change),
    );
  } catch (error) {
    if (error instanceof RangeError) return refused(`These changes can't be taken back alone: ${error.message}.`);
    throw error;
  }
  return replaced(level, parts.length === 1 ? `Take back: ${parts[0].words}` : `Take back ${parts.length} changes`, file);
}

/** Makes a new level file of a version and opens it. @returns whether it was made; a refusal is shown as a notice */
export async function openAsCopy(editor: Editor, id: string, file: LevelFile): Promise<boolean> {
  const levels = editor.workspace.store.getState().list?.levels ?? [];
  const { stem, name } = copyOf(levels, id, file.name);
  return (await addLevels(editor, folderOf(id), [{ stem, file: { ...file, name } }])).length > 0;
}
