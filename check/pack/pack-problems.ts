import { closestName, levelOfEntry, levelsOfPack, type PackEntry, type PackReading, type Problem } from '../../schema/index.ts';
import { plural } from '../words/index.ts';
import { inPackOrder } from './arrange.ts';
import { EFFECT_NAMES, effectInWords, introductionsOf, type MetLevel } from './sequence.ts';

type ReadPack = Extract<PackReading, { readonly ok: true }>;
type JsonPath = readonly (string | number)[];

/** More levels are not named in one message. */
const MOST_NAMED = 10;

/** A problem whose place in the text is not yet known. */
interface Found {
  readonly code: string;
  readonly severity: Problem['severity'];
  readonly message: string;
  readonly hint: string;
  readonly at: JsonPath;
}

const quoted = (id: string): string => JSON.stringify(id);

/** `a`, `a and b`, `a, b and c`. */
function listed(words: readonly string[]): string {
  const last = words.at(-1) ?? '';
  return words.length < 2 ? last : `${words.slice(0, -1).join(', ')} and ${last}`;
}

const effectsInWords = (names: readonly string[]): string => listed(names.map(effectInWords));

const wordOf = (count: number): string => ['no', 'one', 'two', 'three', 'four', 'five', 'six'][count] ?? String(count);

/**
 * What is wrong with a pack, and what looks wrong: levels that are not there, are listed twice or not at all, that introduce
 * several things at once, and empty chapters. It depends on nothing but what it is given, so the command line and the editor say the same.
 *
 * @param reading - the pack file, which is valid
 * @param levels - all levels of the folder, in any order
 * @returns the problems with their places, in the order of the text
 */
export function packProblems({ pack, locate }: ReadPack, levels: readonly MetLevel[]): Problem[] {
  const found = [
    ...missingLevels(pack.levels, levels),
    ...repeatedLevels(pack.levels),
    ...emptyChapters(pack.levels),
    ...unlistedLevels(pack.levels, levels),
    ...introductions(pack.levels, levels),
  ];
  const placed = found.map(({ at, ...problem }) => ({ ...problem, ...locate(at) }));
  return placed.sort((a, b) => a.line - b.line || a.column - b.column);
}

/** The id that was meant by one that is not there; null if none is close. */
function meantBy(id: string, known: readonly string[]): string | null {
  const bare = id
    .replaceAll('\\', '/')
    .replace(/^(?:\.?\/)+/, '')
    .replace(/(?:\.level)?\.json$/i, '');
  return known.find((one) => one === bare) ?? closestName(bare, known);
}

function missingLevels(entries: readonly PackEntry[], levels: readonly MetLevel[]): Found[] {
  const ids = levels.map(({ id }) => id);
  const there = new Set(ids);
  const taken = new Set(entries.flatMap((entry) => levelOfEntry(entry) ?? []));
  // rather a level that is not listed yet, such as the new name of one that was renamed
  const free = ids.filter((id) => !taken.has(id));
  return entries.flatMap((entry, i): Found[] => {
    const id = levelOfEntry(entry);
    if (id === null || there.has(id)) return [];
    const meant = meantBy(id, free) ?? meantBy(id, ids);
    const guess = meant === null ? '' : `: did you mean ${quoted(meant)}?`;
    const write = meant === null ? 'Correct it' : `Write ${quoted(meant)}`;
    return [
      {
        code: 'pack-missing-level',
        severity: 'error',
        message: `there is no level ${quoted(id)} in this folder${guess}`,
        hint: `${write}, or remove the entry.`,
        at: placeOf(entry, i),
      },
    ];
  });
}

const placeOf = (entry: PackEntry, index: number): JsonPath =>
  typeof entry === 'object' && 'level' in entry ? ['levels', index, 'level'] : ['levels', index];

function repeatedLevels(entries: readonly PackEntry[]): Found[] {
  const first = new Map<string, number>();
  return entries.flatMap((entry, i): Found[] => {
    const id = levelOfEntry(entry);
    if (id === null) return [];
    const before = first.get(id);
    if (before === undefined) {
      first.set(id, i);
      return [];
    }
    const message = `the level ${quoted(id)} is listed twice: entry ${before + 1} and entry ${i + 1}`;
    const hint = 'Keep one of them: the game can keep one progress of a level.';
    return [{ code: 'pack-repeated-level', severity: 'error', message, hint, at: placeOf(entry, i) }];
  });
}

function emptyChapters(entries: readonly PackEntry[]): Found[] {
  return entries.flatMap((entry, i): Found[] => {
    if (typeof entry !== 'object' || !('chapter' in entry)) return [];
    const next = entries[i + 1];
    if (next !== undefined && levelOfEntry(next) !== null) return [];
    const message = `the chapter ${quoted(entry.chapter)} has no level`;
    return [
      {
        code: 'pack-empty-chapter',
        severity: 'warning',
        message,
        hint: 'Put a level below it, or remove it.',
        at: ['levels', i],
      },
    ];
  });
}

function unlistedLevels(entries: readonly PackEntry[], levels: readonly MetLevel[]): Found[] {
  const taken = new Set(entries.flatMap((entry) => levelOfEntry(entry) ?? []));
  const left = levels
    .map(({ id }) => id)
    .filter((id) => !taken.has(id))
    .sort((a, b) => (a < b ? -1 : a > b ? 1 : 0));
  if (left.length === 0) return [];
  const names = left.slice(0, MOST_NAMED).map(quoted);
  const more = left.length - names.length;
  const words = listed(more > 0 ? [...names, `${more} more`] : names);
  const message = `${plural(left.length, 'level')} of this folder ${left.length === 1 ? 'is' : 'are'} not listed: ${words}`;
  const hint =
    'Players do not get them: gq build leaves them out. List them where they belong, or leave them out with "ignore" in gq.config.json.';
  return [{ code: 'pack-unlisted-level', severity: 'warning', message, hint, at: ['levels'] }];
}

/** What is said about the effects that players meet for the first time. */
function introductions(entries: readonly PackEntry[], levels: readonly MetLevel[]): Found[] {
  const order = levelsOfPack({ levels: [...entries] });
  const there = new Set(order);
  const inOrder = inPackOrder(
    levels.filter(({ id }) => there.has(id)),
    ({ id }) => id,
    order,
  );
  const first = introductionsOf(inOrder);
  const seen = new Set<string>();
  return entries.flatMap((entry, i): Found[] => {
    const id = levelOfEntry(entry);
    if (id === null) return [];
    const meant = typeof entry === 'object' && 'introduces' in entry ? (entry.introduces ?? []) : [];
    const misspelt = unknownEffects(meant, i);
    const news = first.get(id);
    // of a level that is listed twice, the first place counts
    if (news === undefined || seen.has(id)) return misspelt;
    seen.add(id);
    return [...misspelt, ...falseIntroductions(id, meant, inOrder, first, i), ...crowded(id, meant, news, i)];
  });
}

function unknownEffects(meant: readonly string[], index: number): Found[] {
  return meant.flatMap((name, k): Found[] => {
    if (EFFECT_NAMES.includes(name)) return [];
    const guess = closestName(name, EFFECT_NAMES);
    return [
      {
        code: 'unknown-value',
        severity: 'error',
        message: `no effect is called ${quoted(name)}${guess === null ? '' : `: did you mean ${quoted(guess)}?`}`,
        hint: guess === null ? `Write one of ${EFFECT_NAMES.join(', ')}.` : `Write ${quoted(guess)}.`,
        at: ['levels', index, 'introduces', k],
      },
    ];
  });
}

/** Effects that a level is said to introduce, and does not. */
function falseIntroductions(
  id: string,
  meant: readonly string[],
  inOrder: readonly MetLevel[],
  first: ReadonlyMap<string, readonly string[]>,
  index: number,
): Found[] {
  return meant.flatMap((name, k): Found[] => {
    if (!EFFECT_NAMES.includes(name) || first.get(id)?.includes(name)) return [];
    const hasIt = inOrder.find((level) => level.id === id)?.effects?.includes(name) === true;
    const owner = [...first].find(([, news]) => news.includes(name))?.[0];
    const because = hasIt ? `players meet it in ${quoted(owner ?? '')} before` : 'it does not call for it';
    const message = `${quoted(id)} is meant to introduce ${effectInWords(name)}, but ${because}`;
    const hint = hasIt
      ? 'Move one of the two levels, or remove the effect here.'
      : 'Add it to the level, or remove the effect here.';
    return [{ code: 'pack-introduction', severity: 'warning', message, hint, at: ['levels', index, 'introduces', k] }];
  });
}

/** That a level introduces several things at once, and is not meant to. */
function crowded(id: string, meant: readonly string[], news: readonly string[], index: number): Found[] {
  const isMeant = news.every((name) => meant.includes(name));
  if (news.length < 2 || isMeant) return [];
  const message = `${quoted(id)} is the first level with ${effectsInWords(news)}: players meet ${wordOf(news.length)} new things at once`;
  const entry = `{ "level": ${quoted(id)}, "introduces": [${news.map(quoted).join(', ')}] }`;
  const hint = `Put a level before it that has only one of them, or say that it is meant: ${entry}.`;
  return [{ code: 'pack-introduction', severity: 'warning', message, hint, at: ['levels', index] }];
}
