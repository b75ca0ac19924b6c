import { levelHash } from '../../game/index.ts';
import { type LevelEntry, readLevel } from '../../schema/index.ts';
import type { Editor } from '../context/index.ts';
import { allLevels, folderTermsIn } from '../files/index.ts';
import { keptWith } from '../kept/index.ts';

/** The hashes of levels that were read, by file, version and rules. */
const hashesOf = keptWith<Editor, Map<string, string | null>>(() => new Map());

async function hashOf(editor: Editor, { id, etag }: LevelEntry): Promise<string | null> {
  const { storage, store } = editor.workspace;
  const { rules } = folderTermsIn(store.getState());
  const hashes = hashesOf(editor);
  const key = JSON.stringify([id, etag, rules]);
  const before = hashes.get(key);
  if (before !== undefined) return before;
  const answer = await storage.read(id);
  const reading = answer.ok ? readLevel(answer.value.text ?? '', { rules }) : null;
  const hash = reading?.ok === true ? levelHash(reading.level) : null;
  if (answer.ok) hashes.set(key, hash);
  return hash;
}

/** Finds levels of the folder by their hashes. It reads their files, until all are found. */
export async function levelsByHash(editor: Editor, wanted: ReadonlySet<string>): Promise<ReadonlyMap<string, LevelEntry>> {
  const found = new Map<string, LevelEntry>();
  for (const entry of await allLevels(editor.workspace)) {
    if (found.size === wanted.size) break;
    if (entry.status !== 'valid') continue;
    const hash = await hashOf(editor, entry);
    if (hash !== null && wanted.has(hash) && !found.has(hash)) found.set(hash, entry);
  }
  return found;
}
