import { spawnSync } from 'node:child_process';
import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import {
  atLeast,
  atMost,
  type Bench,
  define,
  flag,
  number,
  numbers,
  oneOf,
  publish,
  readOptions,
  tableOf,
  text,
  verdictsOf,
  words,
} from '../../bench/harness/index.ts';
import { BENCHES } from '../../bench/list.ts';
import { PROJECT } from '../docs/page.ts';

const benches: readonly (readonly [string, Bench])[] = await Promise.all(
  Object.entries(BENCHES).map(async ([name, load]) => [name, (await load()).bench] as const),
);

describe('the list of benchmarks', () => {
  it('is the one in bench/README.md, with the same words', () => {
    const page = readFileSync(join(PROJECT, 'bench/README.md'), 'utf8');
    const told = [...page.matchAll(/^npm run bench -- ([\w-]+) +# (.*)$/gm)].map(([, name, what]) => [name, what]);
    expect(Object.fromEntries(told)).toEqual(Object.fromEntries(benches.map(([name, { what }]) => [name, what])));
    expect(told.length).toBe(benches.length);
  });

  it.each(benches)('%s stands in the file of its name, and says what its options are for', (name, { options }) => {
    expect(existsSync(join(PROJECT, 'bench', `${name}.ts`))).toBe(true);
    for (const { what } of Object.values(options)) expect(what).toMatch(/\w/);
  });
});

describe('options', () => {
  const OPTIONS = {
    seeds: number(20, 'seeds'),
    ticks: number(null, 'ticks'),
    doors: numbers([2, 3], 'doors'),
    set: oneOf(['random', 'styled'], 'random', 'the set'),
    only: words('names'),
    mineralSeeds: number(3, 'more seeds'),
    out: text('a file'),
    brief: flag('briefly'),
  };

  it('are what is asked for, and what holds otherwise', () => {
    const otherwise = {
      seeds: 20,
      ticks: null,
      doors: [2, 3],
      set: 'random',
      only: null,
      mineralSeeds: 3,
      out: null,
      brief: false,
    };
    expect(readOptions(OPTIONS, [])).toEqual(otherwise);
    const args = '--seeds 5 --ticks 1e6 --doors 1,0.5 --set styled --only a,b --only c --mineral-seeds 0 --out x --brief'.split(
      ' ',
    );
    expect(readOptions(OPTIONS, args)).toEqual({
      seeds: 5,
      ticks: 1e6,
      doors: [1, 0.5],
      set: 'styled',
      only: ['a', 'b', 'c'],
      mineralSeeds: 0,
      out: 'x',
      brief: true,
    });
  });

  it.each([
    ['--seeds many', /--seeds: expected a number, 0 or more, found many/],
    ['--seeds -1', /--seeds/],
    ['--set other', /--set: expected one of random, styled, found other/],
    ['--doors 1,,2', /--doors: expected a number/],
    ['--nothing 1', /--nothing/],
    ['something', /something/],
  ])('%s is refused', (args, problem) => {
    expect(() => readOptions(OPTIONS, args.split(' '))).toThrow(problem);
  });
});

describe('claims', () => {
  const bench = define({
    what: 'a thing',
    options: {},
    claims: { cost: atMost(2, 'cost'), rate: atLeast(0.5, 'rate'), other: atMost(1, 'other') },
    run: () => ({ title: '', columns: [], rows: [], measured: { cost: 1, rate: {}, other: null }, notes: [] }),
  }) as Bench;
  const report = (measured: Record<string, number | Record<string, number> | null>) => ({
    title: 'Things',
    columns: ['thing', 'ms'],
    rows: [
      ['a', 1.23456],
      ['bb', null],
    ],
    measured,
    notes: [],
  });

  it('are held against each figure, and left out where nothing was measured', () => {
    const verdicts = verdictsOf(bench, report({ cost: { one: 2, two: 2.1 }, rate: 0.4, other: null }));
    expect(verdicts.map(({ what, met }) => [what, met])).toEqual([
      ['one: cost', true],
      ['two: cost', false],
      ['rate', false],
    ]);
  });

  it('decide what the runner ends with', () => {
    const { log } = console;
    const lines: string[] = [];
    console.log = (line: string) => lines.push(line);
    try {
      expect(publish(bench, report({ cost: 2, rate: 0.5, other: null }), false)).toBe(true);
      expect(publish(bench, report({ cost: Number.NaN, rate: 0.5, other: null }), true)).toBe(false);
    } finally {
      console.log = log;
    }
    expect(lines).toContain('met      cost: 2 (at most 2)');
    expect(JSON.parse(lines.at(-1) ?? '').claims[0]).toMatchObject({ what: 'cost', met: false, measured: null });
  });

  it('stand under a table', () => {
    expect(tableOf(report({}))).toEqual(['thing     ms', '-----  -----', 'a      1.235', 'bb         -']);
  });
});

describe('npm run bench', () => {
  const run = (...args: string[]) =>
    spawnSync(process.execPath, [join(PROJECT, 'dist/bench/run.js'), ...args], { encoding: 'utf8' });

  it('says what is wrong with its command line, and ends with 2', () => {
    const unknown = run('nothing');
    expect([unknown.status, unknown.stderr]).toEqual([2, expect.stringMatching(/^expected the name .*, found nothing: .*\n$/)]);
  });

  it('ends with 1 if a claim is not met, and with 0 otherwise', () => {
    const soak = (seconds: number) => run('soak', '--attack', 'contacts', '--scenes', '3', '--seconds', String(seconds));
    const tried = soak(100);
    expect([tried.status, tried.stdout]).toEqual([0, expect.stringMatching(/met {6}contacts: bugs: 0 \(at most 0\)/)]);
    // nothing tried is never green
    const idle = soak(0);
    expect([idle.status, idle.stdout]).toEqual([1, expect.stringContaining('NOT MET  contacts: tried: 0 (at least 1)')]);
  });
});
