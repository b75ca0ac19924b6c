import { readFileSync } from 'node:fs';
import { type LevelFile, readLevel, withIds } from '../../schema/index.ts';

/** The file of a shipped level by its name in `levels/`, as the editor opens it. */
export function shippedFile(slug: string): LevelFile {
  const reading = readLevel(readFileSync(new URL(`../../levels/${slug}.level.json`, import.meta.url)));
  if (!reading.ok) throw new Error(slug);
  return withIds(reading.document.file);
}
