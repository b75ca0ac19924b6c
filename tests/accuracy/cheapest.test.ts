import { describe, expect, it } from 'vitest';
import { findCheapestSetting, type KeptRun } from '../../check/index.ts';
import { cheapestJson, cheapestPretty } from '../../cli/commands/accuracy/cheapest-report.ts';
import { PLAIN } from '../../cli/terminal/terminal.ts';
import { ACCURACIES, type Accuracy, accuracyOf, compile, DEFAULT_TERMS, simulate } from '../../engine/index.ts';
import { cheapestReportSchema, resolveLevel } from '../../schema/index.ts';
import { findSlack } from '../../solver/index.ts';
import { plainLevel } from '../engine/plain-level.ts';
import { pack } from '../levels/shipped-pack.ts';
import { SPECK } from './scenes.ts';

/** A clock by which all settings cost about the same, so that they are tried in the order that is given. */
const ticking = () => {
  let readings = 0;
  return () => readings++;
};

const find = (runs: readonly KeptRun[], methods: readonly Accuracy[], terms = DEFAULT_TERMS) =>
  findCheapestSetting(runs, { terms, methods, now: ticking(), budget: { timing: 60, most: 1e6, all: 1e9 } });

const runsOf = (...slugs: string[]): KeptRun[] =>
  pack
    .filter(({ slug }) => slugs.some((part) => slug.endsWith(part)))
    .flatMap(({ slug, level }) => level.runs.map(({ name, holds }) => ({ file: slug, name, level, holds })));

const speck: KeptRun = { file: 'speck', name: 'drift', level: resolveLevel(SPECK), holds: [] };
const { arcade, fast, standard, precise } = ACCURACIES;

describe('the cheapest setting', () => {
  it('is the first that keeps outcomes, minerals and slack of all runs; what each other changes is true', () => {
    const runs = runsOf('first-swing', 'slingshot', 'pebbles');
    const coarse = accuracyOf({ integrator: 'euler', rate: 15, tolerance: null, contact: 'frame' });
    const { tried, cheapest, doubts } = find(runs, [coarse, arcade, fast, standard, precise]);
    expect(doubts).toEqual([]);
    const end = (run: KeptRun, accuracy: Accuracy) => {
      const scene = compile(run.level, accuracy);
      const { outcome, minerals } = simulate(scene, run.holds);
      const indices = new Set(minerals.map(({ index }) => index));
      return { outcome, minerals: [...indices].sort(), slack: findSlack(scene, run.holds, { minerals: indices.size }) };
    };
    expect(tried.length).toBeGreaterThan(1);
    for (const { accuracy, broken, error } of tried) {
      if (broken !== null) expect(end(broken.run, accuracy)).not.toEqual(end(broken.run, precise));
      else {
        expect(runs.map((run) => end(run, accuracy))).toEqual(runs.map((run) => end(run, precise)));
        expect(error?.px).toBeGreaterThan(0);
      }
    }
    expect(tried.filter(({ broken }) => broken === null)).toEqual([cheapest]);
    expect(tried.at(-1)).toBe(cheapest);
  });

  it('is not one whose frames jump over a nova that the reference touches', () => {
    const { tried, cheapest } = find([speck], [arcade, standard]);
    expect(tried[0].broken?.what).toBe('completed, not collided');
    expect(cheapest?.accuracy).toBe(standard);
  });

  it('is not looked for where a run takes more work at precise than is allowed: nothing could be compared with it', () => {
    const found = find(runsOf('slingshot'), [arcade, precise], { ...DEFAULT_TERMS, maxWork: 10 });
    expect([found.tried, found.cheapest]).toEqual([[], null]);
    expect(found.doubts[0].doubt).toMatch(/more than 10 pieces of motion at precise/);
  });

  it('is none where no setting keeps all runs, and that is said by name', () => {
    const found = find([speck], [arcade]);
    expect(found.cheapest).toBeNull();
    const report = { found, terms: { accuracy: 'precise', maxTime: 60, maxWork: 400_000, rules: {} }, runs: 1 };
    expect(cheapestPretty(report, PLAIN, null)).toMatch(
      /arcade .*Past a speck, "drift": completed, not collided\n\nNo setting keeps 1 run\.\n/,
    );
    const json = cheapestReportSchema.parse(JSON.parse(cheapestJson(report)));
    expect(json).toMatchObject({ runs: 1, cheapest: null, tried: [{ name: 'arcade', broken: { file: 'speck', run: 'drift' } }] });
  });

  it('is not known where the time is used up before one is found, and what was not tried is said by name', () => {
    const [run] = runsOf('slingshot');
    const methods = [arcade, fast, precise];
    const within = (all: number) => {
      const budget = { timing: 60, most: 1e6, all };
      const found = findCheapestSetting([run], { terms: DEFAULT_TERMS, methods, now: ticking(), budget });
      return { found, terms: { accuracy: 'precise', maxTime: 60, maxWork: 400_000, rules: {} }, runs: 1 };
    };
    const unknown = within(5);
    expect(unknown.found).toMatchObject({ tried: [], cheapest: null, untried: methods });
    expect(cheapestPretty(unknown, PLAIN, null)).toMatch(
      /in time; not tried: arcade; fast; precise\.\n.*the time was used up before it was known what is to be kept/,
    );
    const untried = within(300);
    expect(untried.found).toMatchObject({ tried: [], cheapest: null, untried: methods, doubts: [] });
    expect(cheapestReportSchema.parse(JSON.parse(cheapestJson(untried)))).toMatchObject({
      untried: methods.map(({ name }) => name),
    });
  });

  it('names a run that takes more work than is allowed, and one whose reference is in doubt', () => {
    const [run] = runsOf('firewalk');
    const { tried } = find([run], [standard], { ...DEFAULT_TERMS, maxWork: 300 });
    expect(tried[0].broken?.what).toBe('takes more than 300 pieces of motion');
    const stuck = plainLevel({
      range: 400,
      asteroids: [{ x: 0, y: 0, radius: 16 }],
      repulsors: [{ x: 20, y: 0, radius: 30 }],
    });
    const found = find([{ file: 'stuck', name: 'hold', level: stuck, holds: [[0, 60]] }], [precise], {
      ...DEFAULT_TERMS,
      maxTime: 1,
    });
    const report = { found, terms: { accuracy: 'precise', maxTime: 1, maxWork: 400_000, rules: {} }, runs: 1 };
    expect(cheapestPretty(report, PLAIN, null)).toContain('Cheapest, as far as is known: precise,');
    expect(found.doubts).toMatchObject([
      { run: { file: 'stuck' }, doubt: expect.stringMatching(/no reference covers this run/) },
    ]);
  });
});
