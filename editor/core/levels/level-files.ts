import { addLevels as listLevels, removeLevels as unlistLevels } from '../../../check/pack/index.ts';
import { formatLevel, type LevelEntry, type LevelFile, levelsOfPack } from '../../../schema/index.ts';
import { readContent } from '../../../schema/level/index.ts';
import type { Editor } from '../context/index.ts';
import { folderOf, folderPackIn, idsIn } from '../files/index.ts';
import { type ListStep, listHistoryOf } from './list-history.ts';
import { changePack, tellError, valueOrNotice } from './pack-steps.ts';

/** The name of a level's file, without folder and extension. */
export const stemOf = (id: string): string => id.slice(id.lastIndexOf('/') + 1);

export const inFolder = (folder: string, stem: string): string => (folder === '' ? stem : `${folder}/${stem}`);

/**
 * A free id: the wanted one, or one with a number appended. File names that differ only in case count as equal, as some systems
 * do not distinguish them.
 */
export function freeId(levels: readonly { readonly id: string }[], folder: string, stem: string): string {
  const taken = new Set(levels.map(({ id }) => id.toLowerCase()));
  let id = inFolder(folder, stem);
  for (let i = 2; taken.has(id.toLowerCase()); i++) id = inFolder(folder, `${stem}-${i}`);
  return id;
}

/** the number that a file name begins with, as it is written, and what follows it */
const NUMBERED = /^(\d{1,6})([ ._-].*)$/;

/** The number after the highest one of these files, padded to their width; null if none has a number. */
function numberAfter(stems: readonly string[]): string | null {
  const numbers = stems.flatMap((stem) => NUMBERED.exec(stem)?.[1] ?? []);
  if (numbers.length === 0) return null;
  const width = Math.max(...numbers.map(({ length }) => length));
  return String(Math.max(...numbers.map(Number)) + 1).padStart(width, '0');
}

const stemsIn = (levels: readonly { readonly id: string }[], folder: string): string[] => idsIn(levels, folder).map(stemOf);

/** `07-` for the next level of a folder whose levels are all numbered, else ''. */
export function nextNumber(levels: readonly { readonly id: string }[], folder: string): string {
  const stems = stemsIn(levels, folder);
  const next = numberAfter(stems);
  return next === null || !stems.every((stem) => NUMBERED.test(stem)) ? '' : `${next}-`;
}

/** greatest length of a file name and of a level name, in characters */
const LONGEST = { stem: 80, name: 120 } as const;

/** The words followed by a mark, cut so that both fit. */
const marked = (words: string, mark: string, most: number): string => `${words.slice(0, most - mark.length).trimEnd()}${mark}`;

/** An id for a copy: `07-slingshot-copy` of `02-slingshot` if six levels are numbered, else `slingshot-copy`. */
export function copyId(levels: readonly { readonly id: string }[], id: string): string {
  const folder = folderOf(id);
  const stem = stemOf(id).replace(/-copy(-\d+)?$/i, '');
  const rest = NUMBERED.exec(stem)?.[2];
  const next = rest === undefined ? null : numberAfter(stemsIn(levels, folder));
  return freeId(levels, folder, marked(next === null ? stem : `${next}${rest}`, '-copy', LONGEST.stem - 5));
}

/** A free name for a copy: `Slingshot copy`, `Slingshot copy 2`. */
export function copyName(levels: readonly { readonly name: string | null }[], name: string): string {
  const taken = new Set(levels.map((level) => level.name));
  const original = name.replace(/ copy( \d+)?$/, '');
  let copy = marked(original, ' copy', LONGEST.name);
  for (let i = 2; taken.has(copy); i++) copy = marked(original, ` copy ${i}`, LONGEST.name);
  return copy;
}

/** The file and the name of a copy of a level in the same folder. */
export const copyOf = (
  levels: readonly LevelEntry[],
  id: string,
  name: string,
): { readonly stem: string; readonly name: string } => ({
  stem: stemOf(copyId(levels, id)),
  name: copyName(levels, name),
});

const levelsOf = ({ workspace }: Editor): readonly LevelEntry[] => workspace.store.getState().list?.levels ?? [];

/** Whether the page stopped while it was opening this level. */
function isHeldBack({ workspace, marks }: Editor, id: string): boolean {
  return marks.has(`${workspace.store.getState().list?.folder.id ?? ''}/${id}`);
}

/** Opens a level. A failure is shown as a notice; a level that was being opened when the page stopped is asked about first. */
export async function openListed(editor: Editor, id: string): Promise<void> {
  if (isHeldBack(editor, id)) {
    editor.heldBack.setState(id, true);
    return;
  }
  const opening = await editor.workspace.open(id);
  if (!opening.ok && opening.kind === 'failed') tellError(editor, opening.error);
}

/**
 * Opens a level that an action has created or restored, unless the user has opened another one in the meantime. @param since
 * `openings` when the action began
 */
async function openAfter(editor: Editor, id: string, since: number): Promise<void> {
  if (editor.workspace.openings() === since) await openListed(editor, id);
}

/** Opens a level that was held back. @param checked whether it is simulated and analysed as usual */
export async function openHeldBack(editor: Editor, id: string, checked: boolean): Promise<void> {
  const { workspace, marks, unchecked } = editor;
  marks.clear(`${workspace.store.getState().list?.folder.id ?? ''}/${id}`);
  if (checked) unchecked.delete(id);
  else unchecked.add(id);
  await openListed(editor, id);
}

/** Opens the level that was last open, or else the first valid one. */
export async function openFirst(editor: Editor, last: string | null): Promise<void> {
  const levels = levelsOf(editor);
  const first = levels.find(({ id }) => id === last) ?? levels.find(({ status }) => status === 'valid');
  if (first !== undefined) await openListed(editor, first.id);
}

/** Writes new levels and opens the first. @returns their ids; failures are reported and left out */
export async function addLevels(
  editor: Editor,
  folder: string,
  wanted: readonly { readonly stem: string; readonly file: LevelFile }[],
): Promise<readonly string[]> {
  const since = editor.workspace.openings();
  const added: string[] = [];
  const schema = folder === '' ? editor.workspace.store.getState().list?.folder.$schema : null;
  for (const { stem, file } of wanted) {
    const id = freeId([...levelsOf(editor), ...added.map((id) => ({ id }))], folder, stem);
    const { $schema: _, ...rest } = file;
    const text = formatLevel((schema == null ? rest : { $schema: schema, ...rest }) as LevelFile);
    const answer = await editor.workspace.storage.write(id, text, null);
    if (answer.ok) added.push(answer.value.id);
    else tellError(editor, answer.error);
  }
  await editor.workspace.refresh();
  if (added.length > 0) await listInPack(editor, added);
  if (added.length > 0) await openAfter(editor, added[0], since);
  return added;
}

/** Lists new levels in the order of the pack, if there is one. @param after the level that they follow; null: they are the last */
const listInPack = (editor: Editor, ids: readonly string[], after: string | null = null) =>
  changePack(editor, {
    forward: (pack) => listLevels(pack, ids, after),
    backward: (pack) => unlistLevels(pack, ids),
  });

/** Whether the pack, if there is one, lists a level. */
function isListed({ workspace }: Editor, id: string): boolean {
  const pack = folderPackIn(workspace.store.getState());
  return pack.kind === 'valid' && levelsOfPack(pack.reading.pack).includes(id);
}

/** Adds the levels that come with the toolkit and opens the first. */
export async function addSamples(editor: Editor, folder: string): Promise<void> {
  let samples: typeof import('./samples.ts').SAMPLES;
  try {
    samples = (await import('./samples.ts')).SAMPLES;
  } catch {
    editor.notices.show('warning', 'The sample levels could not be loaded. Reload the page and try again.', {
      topic: 'level-files',
    });
    return;
  }
  await addLevels(editor, folder, samples);
}

/** Copies a level under a new name and number, and opens the copy. */
export async function duplicateLevel(editor: Editor, entry: LevelEntry): Promise<void> {
  const since = editor.workspace.openings();
  const levels = levelsOf(editor);
  const copy = valueOrNotice(editor, await editor.workspace.duplicate(entry, copyId(levels, entry.id)));
  // the copy of a draft is one, too
  if (copy !== null && isListed(editor, entry.id)) await listInPack(editor, [copy.id], entry.id);
  if (copy?.status !== 'valid' || copy.name === null) return;
  await renameTitle(editor, copy, copyName(levels, copy.name));
  await openAfter(editor, copy.id, since);
}

/** Moves a level to the trash. Undo, the notice or the dialog of deleted levels restores it. */
export function deleteLevel(editor: Editor, entry: LevelEntry): Promise<void> {
  const label = `Delete "${entry.name ?? entry.id}"`;
  const since = editor.workspace.openings();
  return listHistoryOf(editor).perform(label, () => removeListed(editor, entry, label, since));
}

async function removeListed(editor: Editor, entry: LevelEntry, label: string, since: number): Promise<ListStep | null> {
  let trash = await putIntoTrash(editor, entry, since);
  if (trash === null) return null;
  let unlisted = await unlistInPack(editor, entry.id);
  const wasOpen = trash.wasOpen;
  let { id } = entry;
  const step: ListStep = {
    label,
    async undo() {
      const restored = trash === null ? null : await takeFromTrash(editor, trash.trash, wasOpen);
      if (restored === null) return false;
      if (restored.id === id) await unlisted?.undo();
      else await listInPack(editor, [restored.id]);
      ({ id } = restored);
      return true;
    },
    async redo() {
      const again = levelsOf(editor).find((level) => level.id === id);
      trash = again === undefined ? null : await putIntoTrash(editor, again, editor.workspace.openings());
      if (trash !== null) unlisted = await unlistInPack(editor, id);
      return trash !== null;
    },
  };
  editor.notices.show('info', `"${entry.name ?? entry.id}" is deleted.`, {
    topic: `deleted ${trash.trash}`,
    actions: [{ title: 'Undo', run: () => listHistoryOf(editor).takeBack(step) }],
  });
  return step;
}

/** Takes a level that is gone out of the order of the pack. */
function unlistInPack(editor: Editor, id: string) {
  const pack = folderPackIn(editor.workspace.store.getState());
  const listed = pack.kind === 'valid' ? levelsOfPack(pack.reading.pack) : [];
  const before = listed[listed.indexOf(id) - 1] ?? null;
  return changePack(editor, {
    forward: (now) => unlistLevels(now, [id]),
    backward: (now) => listLevels(now, [id], before),
  });
}

/**
 * @param since `openings` when the action began
 * @returns its place in the trash and whether it was open; null if it was refused, which is reported
 */
async function putIntoTrash(
  editor: Editor,
  entry: LevelEntry,
  since: number,
): Promise<{ trash: string; wasOpen: boolean } | null> {
  const { workspace } = editor;
  const levels = levelsOf(editor);
  const { opened } = workspace.store.getState();
  const isOpen = opened?.id() === entry.id;
  const index = levels.findIndex(({ id }) => id === entry.id);
  const next = [...levels.slice(index + 1), ...levels.slice(0, Math.max(0, index)).reverse()].find(
    ({ status }) => status === 'valid',
  );
  const done = valueOrNotice(editor, await workspace.remove(entry));
  if (done === null) return null;
  if (isOpen && workspace.openings() === since) {
    if (next !== undefined) await openListed(editor, next.id);
    else await workspace.leave();
  }
  return { trash: done.trashed.trash, wasOpen: isOpen };
}

/** Restores a level from the trash, under another name if its own is taken. A pack gets it as its last level. */
export async function restoreLevel(editor: Editor, trash: string, open: boolean): Promise<LevelEntry | null> {
  const restored = await takeFromTrash(editor, trash, open);
  if (restored !== null) await listInPack(editor, [restored.id]);
  return restored;
}

async function takeFromTrash(editor: Editor, trash: string, open: boolean): Promise<LevelEntry | null> {
  const { workspace } = editor;
  const since = workspace.openings();
  let answer = await workspace.restore(trash);
  if (!answer.ok && answer.error.code === 'name-taken') {
    const listed = await workspace.storage.trash();
    const id = listed.ok ? listed.value.find((entry) => entry.trash === trash)?.id : undefined;
    if (id !== undefined)
      answer = await workspace.restore(trash, freeId(levelsOf(editor), folderOf(id), `${stemOf(id)}-restored`));
  }
  const restored = valueOrNotice(editor, answer);
  if (restored === null) return null;
  editor.notices.clear(`deleted ${trash}`);
  if (open && restored.status === 'valid') await openAfter(editor, restored.id, since);
  return restored;
}

/** Reorders the levels of a folder, which renumbers their files. It can be undone. */
export function orderLevels(editor: Editor, folder: string, ids: readonly string[]): Promise<void> {
  const before = idsIn(levelsOf(editor), folder);
  // the current id of each
  const names = new Map(before.map((id) => [id, id]));
  const order = async (wanted: readonly string[]): Promise<boolean> => {
    const answer = valueOrNotice(
      editor,
      await editor.workspace.order(
        folder,
        wanted.map((id) => names.get(id) ?? id),
      ),
    );
    if (answer === null) return false;
    const renamed = new Map(answer.renamed.map(({ from, to }) => [from, to]));
    for (const [id, name] of names) names.set(id, renamed.get(name) ?? name);
    return true;
  };
  const label = 'Reorder levels';
  const step: ListStep = { label, undo: () => order(before), redo: () => order(ids) };
  return listHistoryOf(editor).perform(label, async () => ((await order(ids)) ? step : null));
}

/** Renames a level; its file keeps its name. */
export async function renameTitle(editor: Editor, { id }: LevelEntry, name: string): Promise<boolean> {
  const open = editor.open.getState();
  if (open?.opened.id() === id) {
    const result = open.document.change('Rename level', (draft) => {
      draft.name = name;
    });
    if (!result.ok) editor.notices.refuse(result.refusal);
    else await open.opened.saver.flush();
    await editor.workspace.refresh();
    return result.ok;
  }
  const { storage } = editor.workspace;
  const answer = await storage.read(id);
  if (!answer.ok) {
    tellError(editor, answer.error);
    return false;
  }
  const reading = readContent(answer.value.text ?? '');
  if (!reading.ok) return false;
  const text = formatLevel({ ...reading.document.file, name });
  const written = await storage.write(id, text, answer.value.etag);
  await editor.workspace.refresh();
  return valueOrNotice(editor, written) !== null;
}

/** Keeps the list up to date with what the saver of the open level writes. @returns stops it */
export function followSaves({ workspace, open }: Editor): () => void {
  let stop = () => {};
  const follow = () => {
    stop();
    const opened = open.getState()?.opened;
    if (opened === undefined) return;
    /**
     * @param isNews whether the saver has just written or merged something; if not, the list may know better that the file is
     * no longer a valid level
     */
    const note = (isNews: boolean) => {
      const { list } = workspace.store.getState();
      const { etag, file } = opened.saver.base();
      const entry = list?.levels.find(({ id }) => id === opened.id());
      if (list === null || entry === undefined || etag === null || (entry.status !== 'valid' && !isNews)) return;
      if (opened.saver.store.getState().kind !== 'saved' || (entry.etag === etag && entry.name === file.name)) return;
      const now: LevelEntry = { ...entry, etag, name: file.name, status: 'valid', problems: [] };
      workspace.store.setState({ list: { ...list, levels: list.levels.map((other) => (other === entry ? now : other)) } });
    };
    note(true);
    const stops = [
      opened.saver.store.subscribe((_, before) => note(before.kind !== 'saved')),
      workspace.store.subscribe(() => note(false)),
    ];
    stop = () => {
      for (const end of stops) end();
    };
  };
  follow();
  const stopOpen = open.subscribe(follow);
  return () => {
    stop();
    stopOpen();
  };
}
