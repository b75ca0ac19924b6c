import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { termsOnDisk } from '../../cli/serve/terms-on-disk.ts';
import { ACCURACIES, type AccuracyName, type Terms, termsOf } from '../../engine/index.ts';
import { checkReportSchema, type LevelFile, type LevelReport } from '../../schema/index.ts';
import { gq, makeFiles } from '../cli/gq.ts';
import { expectDeep, isDeep, isHunt, itDeep, someOf } from '../depth.ts';
import { HEAVY_LEVELS } from '../scenes/heavy-levels.ts';
import { BAD_LEVELS } from '../schema/fixtures/bad-levels.ts';
import { inTheList, onThePage, type Said } from './on-the-page.ts';
import { PROBLEM_LEVELS } from './problem-levels.ts';

const root = join(import.meta.dirname, '..', '..');

/** The permitted differences between the two, with reasons; everything else must be equal. */
const EXCEPTIONS = {
  'a byte order mark is skipped': {
    why: 'the page reads what other programs wrote and writes it anew without the mark; in a file that is checked it would stay',
    applies: ({ problems }: Said) => problems.some(({ code }) => code === 'byte-order-mark'),
  },
  'what the page can play it plays to the end': {
    why: 'the page records nothing of runs that are not shown, which takes less work than a check counts: it says what a check says that is allowed more',
    applies: (name: string) => name === 'heavy: many holds',
    maxWork: 1e8,
  },
} as const;

interface LevelSource {
  readonly name: string;
  readonly source: string | Uint8Array;
}

const levelsIn = (folder: string): LevelSource[] =>
  readdirSync(join(root, folder))
    // the order of the levels is none
    .filter((name) => name !== 'pack.json')
    .map((name) => ({ name: `${folder}/${name}`, source: readFileSync(join(root, folder, name)) }));

const SOURCES: readonly LevelSource[] = [
  ...levelsIn('levels'),
  ...levelsIn('tests/cli/fixtures/levels'),
  ...Object.entries(PROBLEM_LEVELS).map(([name, file]) => ({ name, source: JSON.stringify(file) })),
];
/** These are no levels, at any accuracy. */
const REFUSED: readonly LevelSource[] = BAD_LEVELS.map(({ name, source }) => ({ name: `refused: ${name}`, source }));
/** These exceed the work limit of `gq check`. The one that takes longest is left to a hunt. */
const HEAVY: readonly LevelSource[] = [
  // The page leaves it to a worker, which gives up where the check does.
  { name: 'heavy: aliens', source: JSON.stringify({ ...HEAVY_LEVELS['awake-aliens'](0.1), blackHole: { x: 240, y: 0 } }) },
  { name: 'heavy: aliens on the path', source: JSON.stringify(HEAVY_LEVELS['aliens-on-the-path']()) },
  ...(isHunt ? [{ name: 'heavy: many holds', source: JSON.stringify(HEAVY_LEVELS['many-holds'](0.3)) }] : []),
];

const fileOf = (index: number): string => `${String(index).padStart(4, '0')}.level.json`;
const ALL = [...SOURCES, ...REFUSED, ...HEAVY];
const contents = Object.fromEntries(ALL.map(({ source }, i) => [fileOf(i), source]));
const files = makeFiles(contents);
afterAll(files.remove);
/** The same levels in a folder that sets rules of every kind. */
const CONFIG = {
  rules: { pull: 44, recoil: 3, push: 26, alienPull: 11, alienSight: 190, speedLimit: 700, boxWidth: 26, boxHeight: 26 },
};
const ruled = makeFiles({ ...contents, 'gq.config.json': JSON.stringify(CONFIG) });
afterAll(ruled.remove);

/** What `gq check` says of each, in the order of the list. */
async function onTheCommandLine(
  list: readonly LevelSource[],
  accuracy: AccuracyName,
  more: readonly string[] = [],
  folder = files.directory,
): Promise<Said[]> {
  const names = list.map((source) => fileOf(ALL.indexOf(source)));
  // There are so many files at once that minerals would not be proved, so they are checked in parts.
  const said: Said[] = [];
  for (let from = 0; from < names.length; from += 60) {
    const part = names.slice(from, from + 60);
    const args = ['check', ...part, '--accuracy', accuracy, '--format', 'json', '--jobs', '1', ...more];
    const { stdout, stderr } = await gq(args, { cwd: folder });
    expect(stderr).toBe('');
    const { levels } = checkReportSchema.parse(JSON.parse(stdout));
    expect(levels.map(({ file }) => file)).toEqual(part);
    said.push(...levels.map(({ verdict, problems }: LevelReport) => ({ verdict, problems })));
  }
  return said;
}

/** A place in the text is known where a file is read; on the page a level that could be read has none. */
const withoutPlaces = ({ verdict, problems }: Said): Said => ({
  verdict,
  problems: problems.map((problem) => ({ ...problem, line: null, column: null })),
});

const told = new Set<string>();

function compare({ source }: LevelSource, terms: Terms, byCommand: Said): void {
  told.add(byCommand.verdict);
  for (const { code, severity, pointer, message } of byCommand.problems) {
    told.add(`${code} ${severity}`);
    for (const [hit] of message.matchAll(/collided with (?:nova|hot asteroid|alien)/g)) told.add(hit);
    if (code === 'proved-impossible') told.add(`${code} ${pointer}`);
  }
  const { 'a byte order mark is skipped': mark } = EXCEPTIONS;
  const onPage = onThePage(source, terms);
  if (mark.applies(byCommand)) {
    expect(onPage.problems.map(({ code }) => code)).not.toContain('byte-order-mark');
    return;
  }
  expect(onPage).toEqual(byCommand.verdict === 'invalid' ? byCommand : withoutPlaces(byCommand));
}

/**
 * Every level at `precise`; at `arcade` only half of the shipped ones, which take longest; at the accuracies between them a sixth
 * of all levels. The quick set leaves out three of four shipped ones, and most at other accuracies. All of them in a hunt.
 */
function levelsAt(accuracy: AccuracyName): readonly LevelSource[] {
  if (isHunt || (isDeep && accuracy === 'precise')) return SOURCES;
  const isShipped = ({ name }: LevelSource) => name.startsWith('levels/');
  if (!isDeep) return SOURCES.filter((level, i) => (accuracy === 'precise' ? !isShipped(level) || i % 4 === 0 : i % 12 === 0));
  return SOURCES.filter((level, i) => (accuracy === 'arcade' ? !isShipped(level) || i % 2 === 0 : i % 6 === 0));
}

const checked = new Map<AccuracyName, Promise<Said[]>>();

/** What `gq check` says of the levels at an accuracy; it runs once. */
function checkedAt(accuracy: AccuracyName): Promise<Said[]> {
  const said = checked.get(accuracy) ?? onTheCommandLine(levelsAt(accuracy), accuracy);
  checked.set(accuracy, said);
  return said;
}

describe.each(Object.keys(ACCURACIES) as AccuracyName[])('the page and gq check agree at %s about', (accuracy) => {
  let said: Said[] = [];
  beforeAll(async () => {
    said = await checkedAt(accuracy);
  });

  it.each(levelsAt(accuracy).map((level, i) => [level.name, level, i] as const))('%s', (_, level, i) => {
    compare(level, termsOf(accuracy), said[i]);
    const text = typeof level.source === 'string' ? level.source : new TextDecoder().decode(level.source);
    expect(inTheList(text, termsOf(accuracy))).toBe(said[i].verdict);
  });
});

describe('the page and gq check agree in a folder whose configuration sets rules', () => {
  // A sixth of the levels at either accuracy, and other ones; all of them in a hunt.
  it.each(
    someOf(
      [
        ['precise', 1],
        ['arcade', 2],
      ] as const,
      1,
    ),
  )('at %s', async (accuracy, part) => {
    const list = isHunt ? SOURCES : SOURCES.filter((_, i) => i % 6 === part);
    // As the server sends them to the page.
    const { rules, problems } = termsOnDisk(ruled.directory)();
    const terms = { ...termsOf(accuracy), rules };
    expect([rules, problems]).toEqual([CONFIG.rules, []]);
    const said = await onTheCommandLine(list, accuracy, [], ruled.directory);
    const known = levelsAt(accuracy);
    const without = new Map((await checkedAt(accuracy)).map((each, i) => [known[i], each]));
    for (const [i, level] of list.entries()) {
      compare(level, terms, said[i]);
      const text = typeof level.source === 'string' ? level.source : new TextDecoder().decode(level.source);
      expect(inTheList(text, terms), level.name).toBe(said[i].verdict);
    }
    // Otherwise the rules would not matter.
    const others = list.filter((level, i) => said[i].verdict !== (without.get(level) ?? said[i]).verdict);
    expectDeep(others.length).toBeGreaterThan(1);
  });
});

describe('the page and gq check agree', () => {
  it('about whatever is no level', async () => {
    const said = await onTheCommandLine(REFUSED, 'precise');
    for (const [i, level] of REFUSED.entries()) compare(level, termsOf('precise'), said[i]);
  });

  itDeep('about what exceeds the work limit', async () => {
    const { applies, maxWork } = EXCEPTIONS['what the page can play it plays to the end'];
    const said = await onTheCommandLine(HEAVY, 'precise');
    for (const [i, level] of HEAVY.entries()) {
      expect(said[i].problems.map(({ code }) => code)).toContain('work-limit');
      const [allowedMore] = applies(level.name)
        ? await onTheCommandLine([level], 'precise', ['--max-work', String(maxWork)])
        : [];
      compare(level, termsOf('precise'), allowedMore ?? said[i]);
    }
  });

  it.each(someOf(['precise', 'arcade'] as const, 1))(
    'at %s about what is left out at small work limits, whatever the form of the report',
    async (accuracy) => {
      const level = JSON.parse(readFileSync(join(root, 'levels', '01-first-pull.level.json'), 'utf8')) as LevelFile;
      const [run] = level.runs ?? [];
      const asteroids = [...(level.asteroids ?? []), { x: 40, y: 40, radius: 8 }];
      // the second run is played again for the warning about the asteroid that no run needs
      const source = JSON.stringify({ ...level, asteroids, runs: [run, { ...run, name: 'again' }] });
      const folder = makeFiles({ '01.level.json': source });
      const leftOut = new Set<string>();
      for (let maxWork = 4; maxWork < 6000; maxWork = Math.ceil(maxWork * (accuracy === 'precise' ? 1.3 : 1.5))) {
        const args = ['check', '--accuracy', accuracy, '--max-work', String(maxWork), '--jobs', '1', '--no-cache'];
        const { stdout } = await gq([...args, '--format', 'json', '01.level.json'], { cwd: folder.directory });
        const [said] = checkReportSchema.parse(JSON.parse(stdout)).levels;
        const words = (await gq([...args, '01.level.json'], { cwd: folder.directory })).stdout.replaceAll(/\s+/g, ' ');
        for (const { message } of said.problems) expect(words).toContain(message);
        expect(words.match(/that takes more/g) ?? []).toHaveLength(said.problems.filter((p) => p.code === 'work-limit').length);
        compare({ name: 'small limits', source }, { ...termsOf(accuracy), maxWork }, said);
        for (const { code, message } of said.problems) if (code === 'work-limit') leftOut.add(message.replaceAll(/[\d.]+/g, 'N'));
      }
      folder.remove();
      const by = 'that takes more than the N pieces of motion allowed';
      // at arcade, other accuracies cost less than the runs themselves
      if (accuracy === 'precise') expect(leftOut).toContain(`its runs were not compared at every accuracy: ${by}`);
      expect(leftOut).toContain(`the warnings that depend on its runs were left out: ${by}`);
      expect([...leftOut].some((message) => message.includes('was not played beyond'))).toBe(true);
    },
  );

  it('about levels that a worker has to simulate', async () => {
    const all = await checkedAt('precise');
    const few = levelsAt('precise').flatMap((level, i) =>
      /^levels\/0[1-5]/.test(level.name) || !level.name.includes('/') ? [[level, all[i]] as const] : [],
    );
    let left = 0;
    for (const [{ source }, said] of few) {
      expect(onThePage(source, termsOf('precise'), { most: 3 })).toEqual(withoutPlaces(said));
      left++;
    }
    expect(left).toBeGreaterThan(20);
  });
});

// Otherwise the test would not be about them.
it('the compared levels have every problem that the page can report, and every verdict', () => {
  for (const each of [
    'no-run error',
    'run-does-not-complete error',
    'run-does-not-complete warning',
    'proved-impossible /blackHole',
    'proved-impossible /astronaut',
    'mineral-never-collectable warning',
    'verdict-hangs-on-accuracy warning',
    'unused-allow warning',
    ...(isDeep ? ['work-limit warning', 'work-limit error'] : []),
    'same-place warning',
    'holds-unsorted warning',
    'unknown-key error',
    'completable',
    'broken',
    'unproven',
    'impossible',
    'invalid',
    'collided with nova',
    'collided with hot asteroid',
    'collided with alien',
  ]) {
    expect([...told], each).toContain(each);
  }
});
