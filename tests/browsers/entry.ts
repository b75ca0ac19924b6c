import { type AccuracyName, compile, simulate } from '../../engine/index.ts';
import type { Hold, Level } from '../../schema/index.ts';

/** What every JavaScript engine is asked: the hash of a run. Takes and gives only text, as QuickJS and a page's bridge do. */
export function hashOf(level: string, holds: string, accuracy: string): string {
  return simulate(compile(JSON.parse(level) as Level, accuracy as AccuracyName), JSON.parse(holds) as Hold[]).hash;
}
