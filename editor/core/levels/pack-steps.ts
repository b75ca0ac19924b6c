import { formatPack, PACK_VERSION, type PackFile, readPack } from '../../../schema/index.ts';
import type { Editor } from '../context/index.ts';
import { type Answer, errorInWords, folderPackIn, type StorageError } from '../files/index.ts';
import { listHistoryOf } from './list-history.ts';

/** A change of the order of the levels. */
interface PackChange {
  readonly forward: (pack: PackFile) => PackFile;
  /**
   * Takes it back in a file that somebody has changed since. null: that is not possible, nor is `forward` in a file that has changed,
   * since a new order says something about all levels.
   */
  readonly backward: ((pack: PackFile) => PackFile) | null;
}

/** A change that was made. Each resolves to whether it succeeded; a failure is reported. */
interface MadePackChange {
  undo(): Promise<boolean>;
  redo(): Promise<boolean>;
}

/** Nothing was to be changed. */
const NOTHING: MadePackChange = { undo: async () => true, redo: async () => true };

const textOf = ({ workspace }: Editor): string | null => workspace.store.getState().list?.pack?.text ?? null;

const CHANGED = 'Another program has changed pack.json. It is read again, and its order is shown now';

/** Tells that nothing was done, because the file is not what it was. */
function tellChanged({ notices }: Editor, what: string): void {
  notices.show('warning', `${CHANGED}; ${what}.`, { topic: 'pack' });
}

/**
 * Writes a text in place of the one that is expected. Where the file has another one, it is changed instead, if that is possible.
 * @param otherwise changes a file that has another text; null: that is refused
 */
async function put(
  editor: Editor,
  expected: string | null,
  wanted: string | null,
  otherwise: PackChange['backward'],
  refused: string,
): Promise<boolean> {
  const { workspace } = editor;
  for (let tries = 0; tries < 2; tries++) {
    const now = textOf(editor);
    if (now === wanted) return true;
    // at the second try, the file that has changed is there
    const text = tries === 0 && now === expected ? wanted : changedText(now, otherwise);
    if (text === undefined) break;
    const answer = await workspace.writePack(text);
    if (answer.ok) return true;
    if (answer.error.code !== 'conflict') {
      tellError(editor, answer.error);
      return false;
    }
  }
  tellChanged(editor, refused);
  return false;
}

function changedText(now: string | null, change: PackChange['backward']): string | undefined {
  if (now === null || change === null) return undefined;
  const reading = readPack(now);
  return reading.ok ? formatPack(change(reading.pack)) : undefined;
}

/** Changes the order of the levels, if there is a valid one. @returns null if it was refused, which is reported */
export async function changePack(editor: Editor, { forward, backward }: PackChange): Promise<MadePackChange | null> {
  const pack = folderPackIn(editor.workspace.store.getState());
  if (pack.kind !== 'valid') return NOTHING;
  const before = textOf(editor);
  const after = formatPack(forward(pack.reading.pack));
  // only the layout of the file would change
  if (after === formatPack(pack.reading.pack)) return NOTHING;
  const onto = backward === null ? null : forward;
  if (!(await put(editor, before, after, onto, 'nothing was changed: do it again'))) return null;
  const written = textOf(editor);
  return {
    undo: () => put(editor, written, before, backward, 'so this cannot be undone'),
    redo: () => put(editor, before, written, onto, 'so this cannot be done again'),
  };
}

/** The order of the levels as it is without a `pack.json`. */
function packOfList({ workspace }: Editor): PackFile {
  const { list } = workspace.store.getState();
  const name = /([^/\\]+)[/\\]*$/.exec(list?.folder.path ?? '')?.[1] ?? '';
  const isNamed = workspace.storage.kind === 'server' && !['', '.', '..', 'levels'].includes(name);
  const schema = list?.folder.$schema?.replace(/level(\.schema\.json)$/, 'pack$1');
  return {
    ...(schema !== undefined && { $schema: schema }),
    version: PACK_VERSION,
    name: isNamed ? name : 'My levels',
    levels: (list?.levels ?? []).map(({ id }) => id),
  };
}

/**
 * Changes the order of the levels as one step of undo. Where there is no `pack.json`, it is made with the order of the names first.
 * @returns whether it was done; a refusal is reported
 */
export async function editPack(editor: Editor, label: string, forward: PackChange['forward']): Promise<boolean> {
  let isDone = false;
  await listHistoryOf(editor).perform(label, async () => {
    const made = await changeOrMakePack(editor, forward);
    isDone = made !== null;
    return made === null || made === NOTHING ? null : { label, ...made };
  });
  return isDone;
}

async function changeOrMakePack(editor: Editor, forward: PackChange['forward']): Promise<MadePackChange | null> {
  const pack = folderPackIn(editor.workspace.store.getState());
  if (pack.kind === 'invalid' || pack.kind === 'unreadable') {
    editor.notices.show('warning', `${pack.file} can't be changed here, because it is not valid. Mend it with a text editor.`, {
      topic: 'pack',
    });
    return null;
  }
  if (pack.kind === 'valid') return changePack(editor, { forward, backward: null });
  const text = formatPack(forward(packOfList(editor)));
  if (!(await put(editor, null, text, null, 'nothing was changed: do it again'))) return null;
  return {
    undo: () => put(editor, text, null, null, 'so this cannot be undone'),
    redo: () => put(editor, null, text, null, 'so this cannot be done again'),
  };
}

/** Shows a notice about a failure. */
export function tellError({ notices }: Editor, error: StorageError): void {
  notices.show('warning', errorInWords(error), { topic: 'level-files' });
}

/** The value of an answer; for a refusal null, and a notice says why. */
export function valueOrNotice<T>(editor: Editor, answer: Answer<T>): T | null {
  if (answer.ok) return answer.value;
  tellError(editor, answer.error);
  return null;
}
