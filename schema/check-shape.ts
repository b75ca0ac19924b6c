import * as z from 'zod';
import { KINDS, LISTED_KINDS, OBJECT_LISTS } from './kinds.ts';
import { levelSchema, OBJECT_SCHEMAS } from './level.ts';
import { LIMITS } from './limits.ts';
import { fitsLevel } from './plain/index.ts';
import { type Finding, MAX_FINDINGS, type Path } from './problem.ts';
import { checkPart, found, isObject, named, wrongType } from './shape-findings.ts';

const { shape } = levelSchema;
const runSchema = shape.runs.unwrap().element;
const conflictSchema = shape.conflicts.unwrap().element;

type Parts = { readonly [list: string]: z.core.$ZodType };

interface Compiled {
  readonly root: z.core.$ZodType;
  readonly elements: Parts;
  readonly run: z.core.$ZodType;
  readonly hold: z.core.$ZodType;
  readonly note: z.core.$ZodType;
  readonly conflict: z.core.$ZodType;
}

let compiled: Compiled | null = null;

/**
 * The schemas of a level's parts. zod compiles them on first use: that takes a few ms once, and makes them five times faster.
 */
function parts(): Compiled {
  compiled ??= {
    root: z.compile(levelSchema),
    elements: Object.fromEntries(LISTED_KINDS.map((kind) => [KINDS[kind].list, z.compile(OBJECT_SCHEMAS[kind])])),
    run: z.compile(runSchema),
    hold: z.compile(runSchema.shape.holds.element),
    note: z.compile(runSchema.shape.notes.unwrap().element),
    conflict: z.compile(conflictSchema),
  };
  return compiled;
}

function checkLength(list: readonly unknown[], most: number, path: Path, level: unknown, into: Finding[]): boolean {
  if (list.length <= most) return true;
  const message = `expected at most ${most} entries, found ${list.length}`;
  into.push(named(found(path, 'too-many', message, 'Remove entries, or split the level.'), level));
  return false;
}

/** The lists of a run, with the part that each entry is. */
const LISTS_OF_RUN = [
  { key: 'holds', part: 'hold', most: LIMITS.holds },
  { key: 'notes', part: 'note', most: LIMITS.notes },
] as const;

function checkRuns(runs: readonly unknown[], level: unknown, into: Finding[]): void {
  for (let r = 0; r < runs.length && into.length < MAX_FINDINGS; r++) {
    const run = runs[r];
    const hollow = isObject(run) ? { ...run } : run;
    const lists = LISTS_OF_RUN.flatMap(({ key, part, most }) => {
      const entries = isObject(run) ? run[key] : null;
      if (!Array.isArray(entries)) return [];
      (hollow as Record<string, unknown>)[key] = [];
      return [{ key, part, most, entries }];
    });
    checkPart(parts().run, hollow, ['runs', r], level, into);
    for (const { key, part, most, entries } of lists) {
      if (!checkLength(entries, most, ['runs', r, key], level, into)) continue;
      for (let i = 0; i < entries.length && into.length < MAX_FINDINGS; i++) {
        checkPart(parts()[part], entries[i], ['runs', r, key, i], level, into);
      }
    }
  }
}

/**
 * Checks a JSON value without x- keys against `levelSchema`: keys, types, limits. It checks part by part, so that a file with
 * millions of wrong entries costs no more than one with `MAX_FINDINGS`.
 */
export function checkShape(value: unknown): Finding[] {
  // nearly every file fits: zod, which takes several times as long, is needed only to say what is wrong
  if (fitsLevel(value)) return [];
  const findings: Finding[] = [];
  if (!isObject(value)) return [wrongType([], 'object', value)];
  const hollow = { ...value };
  for (const list of [...OBJECT_LISTS, 'runs', 'conflicts']) if (Array.isArray(hollow[list])) hollow[list] = [];
  checkPart(parts().root, hollow, [], value, findings);
  const checkEach = (list: string, schema: z.core.$ZodType, most: number) => {
    const entries = value[list];
    if (!Array.isArray(entries) || !checkLength(entries, most, [list], value, findings)) return;
    for (let i = 0; i < entries.length && findings.length < MAX_FINDINGS; i++) {
      checkPart(schema, entries[i], [list, i], value, findings);
    }
  };
  checkEach('conflicts', parts().conflict, LIMITS.conflicts);
  for (const list of OBJECT_LISTS) checkEach(list, parts().elements[list], LIMITS.objects);
  if (Array.isArray(value.runs) && checkLength(value.runs, LIMITS.runs, ['runs'], value, findings))
    checkRuns(value.runs, value, findings);
  return findings;
}
