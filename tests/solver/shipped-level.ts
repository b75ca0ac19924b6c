import { readFileSync } from 'node:fs';
import { type Level, readLevel } from '../../schema/index.ts';

/** A shipped level by its name in `levels/`. */
export function shippedLevel(slug: string): Level {
  const reading = readLevel(readFileSync(new URL(`../../levels/${slug}.level.json`, import.meta.url)));
  if (!reading.ok) throw new Error(slug);
  return reading.level;
}
