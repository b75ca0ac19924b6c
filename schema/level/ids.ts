import { OBJECT_LISTS } from '../basics/index.ts';
import type { LevelFile } from './shape.ts';

const LENGTH = 6;

/** 32-bit FNV-1a over UTF-16 units, with the final mixing of murmur3, so that similar texts get different numbers. */
function hash(text: string, seed: number): number {
  let h = 0x811c9dc5 ^ seed;
  for (let i = 0; i < text.length; i++) h = Math.imul(h ^ text.charCodeAt(i), 0x01000193);
  h = Math.imul(h ^ (h >>> 16), 0x85ebca6b);
  h = Math.imul(h ^ (h >>> 13), 0xc2b2ae35);
  return (h ^ (h >>> 16)) >>> 0;
}

const idFor = (content: string, attempt: number): string =>
  hash(content, attempt).toString(36).padStart(LENGTH, '0').slice(-LENGTH);

/**
 * Gives every object of a level file an id. Existing ids stay. A new id depends only on the object's list, content and place,
 * so that two people who add objects in two branches get different ids, and the same file always gets the same ones.
 *
 * @param file - the level file; it is not changed
 * @returns a copy in which every object has an id
 */
export function withIds(file: LevelFile): LevelFile {
  const taken = new Set<string>();
  const attempts = new Map<string, number>();
  for (const list of OBJECT_LISTS) for (const object of file[list] ?? []) if (object.id !== undefined) taken.add(object.id);
  const name = <T extends { id?: string | undefined }>(list: string, object: T): T => {
    if (object.id !== undefined) return object;
    const content = `${list}${JSON.stringify(object)}`;
    // equal objects continue with the attempt after the last one, or thousands of them would take millions of attempts
    let attempt = attempts.get(content) ?? 0;
    let id = idFor(content, attempt++);
    while (taken.has(id)) id = idFor(content, attempt++);
    attempts.set(content, attempt);
    taken.add(id);
    return { ...object, id };
  };
  const named = { ...file };
  for (const list of OBJECT_LISTS) {
    const objects: readonly { id?: string | undefined }[] | undefined = file[list];
    if (objects !== undefined) named[list] = objects.map((object) => name(list, object)) as never;
  }
  return named;
}
