import { createHash } from 'node:crypto';
import type { EditEvent, ListResponse } from '../../schema/index.ts';
import { schemaReference } from '../schema-reference.ts';
import { changesBetween } from './changes.ts';
import { findLevels, inOrderOfPlay } from './level-files.ts';
import { type EntryReader, entryOf } from './read-entry.ts';

/** What everybody has been told of a folder, kept the same as the disk. */
export interface KnownLevels {
  /** Looks at the whole folder and announces what other programs have changed. @returns the list as it is now */
  refresh(): ListResponse;
  /** Looks at some files alone and announces what `by` has done to them. */
  announce(ids: readonly string[], by: string): void;
  /** Tells what goes on from now on; the list comes first. @returns how to end it */
  listen(listener: (event: EditEvent) => void): () => void;
  /** Something about the folder that a person should know from now on. */
  addTrouble(message: string): void;
}

export function createKnownLevels(root: string, shown: string, reader: EntryReader): KnownLevels {
  const listeners = new Set<(event: EditEvent) => void>();
  const troubles: string[] = [];
  const folder = {
    id: createHash('sha256').update(root).digest('hex').slice(0, 16),
    path: shown,
    $schema: schemaReference(root),
  };

  const look = (): ListResponse => {
    const found = findLevels(root);
    const levels = [...found.files.values()].map((file) => entryOf(reader.read(file)));
    reader.keepOnly(new Set(levels.map(({ etag }) => etag)));
    return { folder, folders: [...found.folders], levels, troubles: [...troubles, ...found.troubles] };
  };

  let known = look();
  const become = (next: ListResponse, by: string | null): void => {
    const events = changesBetween(known, next, by);
    known = next;
    for (const event of events) for (const listener of listeners) listener(event);
  };

  const refresh = (): ListResponse => {
    become(look(), null);
    return known;
  };

  const announce = (ids: readonly string[], by: string): void => {
    const { files } = findLevels(root);
    const others = known.levels.filter(({ id }) => !ids.includes(id));
    const touched = [...files.values()].filter(({ id }) => ids.includes(id)).map((file) => entryOf(reader.read(file)));
    become({ ...known, levels: [...others, ...touched].sort((a, b) => inOrderOfPlay(a.id, b.id)) }, by);
  };

  const listen = (listener: (event: EditEvent) => void): (() => void) => {
    refresh();
    listeners.add(listener);
    listener({ type: 'list', list: known });
    return () => listeners.delete(listener);
  };

  const addTrouble = (message: string): void => {
    if (troubles.includes(message)) return;
    troubles.push(message);
    refresh();
  };

  return { refresh, announce, listen, addTrouble };
}
