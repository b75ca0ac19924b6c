import { KINDS, kindOfList, LISTED_KINDS, OBJECT_LISTS, SINGLE_KINDS } from '../../schema/index.ts';

/** What a level file's lists are of. */
const ONE_OF: Readonly<Record<string, string>> = {
  ...Object.fromEntries(OBJECT_LISTS.map((list) => [list, KINDS[kindOfList(list)].one])),
  runs: 'run',
};

/** What may stand before an entry of a list: what it is. */
const WORDS = LISTED_KINDS.flatMap((kind) => {
  const { one, variant } = KINDS[kind];
  return variant === undefined ? [one] : [variant.one, one];
}).join('|');
const LISTS = Object.keys(ONE_OF).join('|');
const SINGLES = SINGLE_KINDS.join('|');

/** A text in quotes, which is left alone; an entry of a list, with its kind before it or not, and what of it; or one of those that are in no list. */
const NAMES = new RegExp(
  [
    '"(?:[^"\\\\]|\\\\.)*"',
    `(?:\\b(${WORDS}) )?(?<![\\w.\\]])(${LISTS})\\[(\\d+)\\]((?:\\.[\\w-]+|\\[\\d+\\])*)`,
    `(?<![\\w.\\]])(${SINGLES})((?:\\.[\\w-]+)+|(?=:))`,
  ].join('|'),
  'g',
);

const ONE_OF_SINGLE: Readonly<Record<string, string>> = Object.fromEntries(SINGLE_KINDS.map((kind) => [kind, KINDS[kind].one]));

/** `.holds[2][1]` is `, hold 3, release` */
function partInWords(part: string): string {
  return part
    .replace(/\.holds\[(\d+)\]/, (_, hold: string) => `, hold ${Number(hold) + 1}`)
    .replace('[0]', ', press')
    .replace('[1]', ', release')
    .replaceAll('.', ', ');
}

/**
 * A message about a level file as the page says it: `asteroids[3].radius: expected …` becomes `asteroid 4, radius: expected …`. The command line
 * names what stands in a file, where lists count from 0; the page names what is seen.
 */
export function inPageWords(message: string): string {
  return message.replace(
    NAMES,
    (all: string, kind?: string, list?: string, index?: string, part?: string, single?: string, partOfSingle?: string) => {
      if (list !== undefined) return `${kind ?? ONE_OF[list]} ${Number(index) + 1}${partInWords(part ?? '')}`;
      if (single !== undefined) return `${ONE_OF_SINGLE[single]}${partInWords(partOfSingle ?? '')}`;
      return all;
    },
  );
}
