import { readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { firstDifference } from '../../check/runs/index.ts';
import { createEditedLevel, moveHold, moveObjects, setLevelProperty, stretchHold } from '../../editor/core/document/index.ts';
import { createProofStore, createProver, type LiveProof } from '../../editor/core/proof/index.ts';
import { RecorderRoom, RunRecorder } from '../../editor/core/proof/recorder.ts';
import type { Tracks } from '../../editor/core/proof/tracks.ts';
import {
  ACCURACIES,
  type AccuracyName,
  boxCircleGap,
  compile,
  createSimulation,
  DEFAULT_BOX,
  DEFAULT_TERMS,
  joinHolds,
  STATE_SIZE,
  simulate,
  termsOf,
} from '../../engine/index.ts';
import { type LevelFile, readLevel } from '../../schema/index.ts';
import { expectDeep, itQuick } from '../depth.ts';
import { arbitraryHolds, arbitraryPlayableLevel } from '../engine/arbitrary-level.ts';

const root = join(dirname(fileURLToPath(import.meta.url)), '..', '..');
const ACCURACY_NAMES = Object.keys(ACCURACIES) as AccuracyName[];
const accuracy = fc.constantFrom(...ACCURACY_NAMES);
const TICKS = 900;

/** A bit-exact text that is quick to compare. */
const bytes = (list: ArrayLike<number>): string => Buffer.from(Float64Array.from(list).buffer).toString('base64');

/** The state of all bodies at every entry. */
const placesOf = (tracks: Tracks, count: number): number[] => Array.from({ length: count }, (_, k) => [...tracks.all(k)]).flat();

/** A copy of everything that a recorder returns, as it reuses its arrays. */
const copied = ({ way, ending, minerals }: ReturnType<RunRecorder['run']>) => ({
  ending,
  minerals,
  last: [...way.last],
  states: way.states.slice(0, STATE_SIZE * way.count),
  held: way.held.slice(0, way.count),
  aliens: placesOf(way.aliens, way.count),
  asteroids: placesOf(way.asteroids, way.count),
});

describe('a recorder', () => {
  it('that continues where two scripts differ has the same bits as one from the start', () => {
    let resumed = 0;
    // reused for all scenes, as in the page
    const room = new RecorderRoom();
    fc.assert(
      fc.property(
        arbitraryPlayableLevel,
        accuracy,
        fc.array(arbitraryHolds(TICKS), { minLength: 2, maxLength: 5 }),
        fc.nat(TICKS),
        (level, name, scripts, part) => {
          const scene = compile(level, name);
          const recorder = new RunRecorder(scene, TICKS, room);
          const first = scripts[0];
          for (const script of scripts) {
            // everything before `part` is the same in all
            const early = first.filter(([, release]) => release < part);
            const holds = joinHolds([...early, ...script.map(([a, b]) => [Math.max(a, part), Math.max(b, part)] as const)]);
            const again = recorder.run(holds);
            if (again.resumedFrom > 0) resumed++;
            const told = copied(again);
            const whole = copied(new RunRecorder(scene, TICKS).run(holds));
            expect(told.ending).toEqual(whole.ending);
            expect(told.minerals).toEqual(whole.minerals);
            for (const part of ['last', 'states', 'held', 'aliens', 'asteroids'] as const)
              expect(bytes(told[part])).toBe(bytes(whole[part]));
          }
        },
      ),
      { numRuns: 20 },
    );
    // otherwise the test would not test continuing
    expectDeep(resumed).toBeGreaterThan(8);
  });

  it('has the same path and end as simulate records', () => {
    fc.assert(
      fc.property(arbitraryPlayableLevel, accuracy, arbitraryHolds(TICKS), (level, name, script) => {
        const scene = compile(level, name);
        const holds = joinHolds(script);
        const run = simulate(scene, holds, { maxTime: TICKS / 60 });
        const { way, ending, minerals } = new RunRecorder(scene, TICKS).run(holds);
        expect(ending?.outcome ?? 'timeout').toBe(run.outcome);
        if (ending !== null) expect([ending.time, ending.tick, ending.with]).toEqual([run.time, run.tick, run.with]);
        if (name !== 'arcade')
          expect(minerals.map(({ index }) => index).sort()).toEqual(run.minerals.map(({ index }) => index).sort());
        for (const { index, tick } of minerals)
          expect(run.minerals.some((m) => m.index === index && Math.floor(m.time * 60 + 1e-6) === tick)).toBe(true);
        const state = new Float64Array(STATE_SIZE);
        let worst = 0;
        for (let k = 0; k < way.count; k++) {
          run.trajectory.at(k / 60, state);
          for (let i = 0; i < 4; i++) worst = Math.max(worst, Math.abs(way.states[STATE_SIZE * k + i] - state[i]));
        }
        expect(worst).toBeLessThan(1e-6);
        expect([...way.last]).toEqual(Object.values(run.final));
      }),
      { numRuns: 25 },
    );
  });

  it('has the places of aliens and asteroids at every tick, though it writes only those that move', () => {
    let stirred = 0;
    fc.assert(
      fc.property(arbitraryPlayableLevel, accuracy, arbitraryHolds(TICKS), (level, name, script) => {
        const scene = compile(level, name);
        const holds = joinHolds(script);
        const { way } = new RunRecorder(scene, TICKS).run(holds);
        const simulation = createSimulation(scene);
        const aliens = new Float64Array(3 * way.aliens.count);
        const asteroids = new Float64Array(2 * way.asteroids.count);
        expect([way.aliens.count, way.asteroids.count]).toEqual([level.aliens.length, level.recoil ? level.asteroids.length : 0]);
        for (let k = 0; k < way.count; k++) {
          // frames have their first state after the first frame
          const ticks = name === 'arcade' ? k + 1 : k;
          if (ticks > 0)
            simulation.advance(
              1,
              holds.some(([press, release]) => press < ticks && ticks <= release),
            );
          if (aliens.length > 0) simulation.readAliens(aliens);
          if (asteroids.length > 0) simulation.readAsteroids(asteroids);
          if (bytes(way.aliens.all(k)) !== bytes(aliens)) expect([k, ...way.aliens.all(k)]).toEqual([k, ...aliens]);
          if (bytes(way.asteroids.all(k)) !== bytes(asteroids)) expect([k, ...way.asteroids.all(k)]).toEqual([k, ...asteroids]);
        }
        for (let i = 0; i < way.aliens.count; i++) if (way.aliens.stirs(i)) stirred++;
      }),
      { numRuns: 20 },
    );
    expectDeep(stirred).toBeGreaterThan(4);
  });

  it('finds where two scripts begin to differ', () => {
    expect(firstDifference([[1, 5]], [[1, 5]])).toBe(Number.POSITIVE_INFINITY);
    expect(firstDifference([[1, 5]], [[1, 6]])).toBe(5);
    expect(firstDifference([[1, 5]], [[2, 5]])).toBe(1);
    expect(
      firstDifference(
        [[1, 5]],
        [
          [1, 5],
          [9, 12],
        ],
      ),
    ).toBe(9);
    expect(firstDifference([], [[3, 4]])).toBe(3);
  });
});

describe('the live proof', () => {
  const reading = readLevel(readFileSync(join(root, 'levels/18-grand-tour.level.json')));
  if (!reading.ok) throw new Error('expected a level');
  const grandTour = reading.document.file;

  it('keeps the scene if only runs change, and the beginning of the run if only its end changes', () => {
    const level = createEditedLevel(grandTour);
    const proof = createProofStore(level, DEFAULT_TERMS);
    const { scene, run } = proof.proof();
    expect(run.outcome).toBe('completed');
    const last = run.holds.length - 1;
    level.change('Move', moveHold(run.name ?? '', last, -1));
    expect(proof.proof().scene).toBe(scene);
    expect(proof.proof().run.resumedFrom).toBeGreaterThan(run.holds[last][0] - 62);
    level.change('Rename', setLevelProperty('name', 'other'));
    expect(proof.proof().scene).toBe(scene);
    expect(proof.proof().level.name).toBe('other');
    level.change('Move', moveObjects([level.file().asteroids?.[0].id ?? ''], 1, 0));
    expect(proof.proof().scene).not.toBe(scene);
    expect(proof.proof().run.resumedFrom).toBe(0);
  });

  it('follows every change, including drags and undo', () => {
    const level = createEditedLevel(grandTour);
    const proof = createProofStore(level, DEFAULT_TERMS);
    const fresh = (): LiveProof => createProver().prove({ file: level.file(), run: null, terms: DEFAULT_TERMS });
    const told = ({ verdict, provenBy, run }: LiveProof) => ({
      verdict,
      provenBy,
      time: run.time,
      outcome: run.outcome,
      last: [...run.way.last],
    });
    const drag = level.begin('Drag');
    for (let i = 0; i < 6; i++) {
      drag.set(moveObjects(['@blackHole'], -100 * i, 100 * i));
      expect(told(proof.proof())).toEqual(told(fresh()));
    }
    drag.commit();
    expect(proof.proof().verdict).toBe('broken');
    level.undo();
    expect(proof.proof().verdict).toBe('completable');
    level.change('Stretch', stretchHold(proof.proof().run.name ?? '', 0, 'release', 1));
    expect(told(proof.proof())).toEqual(told(fresh()));
  });

  it('lets her drift if there is no run', () => {
    const { runs: _, ...file } = grandTour;
    const proof = createProver().prove({ file, run: 'solution', terms: DEFAULT_TERMS });
    expect(proof).toMatchObject({ verdict: 'unproven', provenBy: null, run: { name: null, holds: [] } });
    expect(proof.run.way.count).toBeGreaterThan(1);
    expect(proof.problems[0]).toMatchObject({ code: 'no-run', severity: 'error' });
  });

  it('finds the run that completes the level, whichever is shown', () => {
    const holds = grandTour.runs?.[0].holds ?? [];
    const file: LevelFile = {
      ...grandTour,
      runs: [
        { name: 'fails', holds: [] },
        { name: 'proves', holds },
        { name: 'too', holds },
      ],
    };
    const prover = createProver();
    const by = (run: string | null) => prover.prove({ file, run, terms: DEFAULT_TERMS }).provenBy;
    expect([by(null), by('too'), by('fails'), by('proves'), by('nowhere')]).toEqual([
      'proves',
      'too',
      'proves',
      'proves',
      'proves',
    ]);
  });
});

describe('margins', () => {
  it('are the distance to the nearest hazard at every tick, though most hazards are skipped', () => {
    fc.assert(
      fc.property(arbitraryPlayableLevel, accuracy, arbitraryHolds(TICKS), (level, name, holds) => {
        const prover = createProver();
        const file = {
          ...level,
          version: 1,
          runs: [{ name: 'r', holds }],
          asteroids: level.asteroids.map(({ id: _, ...o }) => o),
        };
        const proof = prover.prove({
          file: JSON.parse(JSON.stringify(file).replaceAll('"id":null,', '')),
          run: null,
          terms: termsOf(name),
        });
        const { way } = proof.run;
        const { gap } = proof.margins;
        for (let k = 0; k < way.count; k += 7) {
          const s = way.states.subarray(STATE_SIZE * k, STATE_SIZE * (k + 1));
          const to = (x: number, y: number, r: number) => boxCircleGap(DEFAULT_BOX, x - s[0], y - s[1], s[4], s[5], r);
          const all = level.novae.map(({ x, y, radius }) => to(x, y, radius));
          for (const [i, { hot, radius, x, y }] of level.asteroids.entries()) {
            const [ax, ay] = way.asteroids.all(k).subarray(2 * i);
            if (hot) all.push(level.recoil ? to(ax, ay, radius) : to(x, y, radius));
          }
          for (const [i, { radius }] of level.aliens.entries()) {
            const [ax, ay, alive] = way.aliens.all(k).subarray(3 * i);
            if (alive !== 0) all.push(to(ax, ay, radius));
          }
          expect(gap[k]).toBe(Math.fround(Math.min(Number.POSITIVE_INFINITY, ...all)));
        }
      }),
      { numRuns: 20 },
    );
  });

  it('name each near miss once', () => {
    const file: LevelFile = {
      version: 1,
      name: 'lane',
      astronaut: { x: 0, y: 0, vx: 100 },
      blackHole: { x: 900, y: 0 },
      range: 2000,
      asteroids: [{ x: 0, y: 300, radius: 16 }],
      novae: [
        { x: 500, y: 45, radius: 16 },
        { x: 300, y: -40, radius: 16 },
        { x: 400, y: 200, radius: 16 },
      ],
      runs: [{ name: 'r', holds: [] }],
    };
    const { margins } = createProver().prove({ file, run: null, terms: DEFAULT_TERMS });
    expect(margins.nearMisses.map(({ kind, index, gap }) => [kind, index, Math.round(gap)])).toEqual([
      ['nova', 1, 8],
      ['nova', 0, 13],
    ]);
    expect(Math.abs(margins.nearMisses[0].tick - 180)).toBeLessThan(8);
    expect(margins.speed[100]).toBeCloseTo(100);
  });
});

describe('a proof that takes too long', () => {
  /** A clock that advances by a step at every reading. */
  const ticking = (step: number) => {
    let time = 0;
    return () => (time += step);
  };
  const file = createEditedLevel(JSON.parse(readFileSync(join(root, 'levels', '02-first-swing.level.json'), 'utf8'))).file();
  const whole = () => createProver().prove({ file, run: null, terms: DEFAULT_TERMS });
  const wayOf = ({ run: { way, outcome, tick } }: LiveProof) => ({
    outcome,
    tick,
    states: [...way.states.subarray(0, STATE_SIZE * way.count)],
    held: [...way.held.subarray(0, way.count)],
  });

  it('is interrupted at its time limit, which it reports, and is not called broken', () => {
    const cut = createProver(ticking(1)).prove({ file, run: null, terms: DEFAULT_TERMS, patience: 50 });
    expect(cut).toMatchObject({ limit: 'run', verdict: 'unproven', provenBy: null, full: null });
    expect(cut.run.way.count).toBeLessThan(60);
    expect(cut.run.way.count).toBeGreaterThan(30);
    expect(cut.problems).toMatchObject([{ code: 'work-limit', message: expect.stringContaining('work limit') }]);
    expect(wayOf(whole()).states.slice(0, STATE_SIZE * (cut.run.way.count - 1))).toEqual(
      wayOf(cut).states.slice(0, STATE_SIZE * (cut.run.way.count - 1)),
    );
  });

  it('continues with a longer limit, with the same bits as without an interruption', () => {
    const full = wayOf(whole());
    for (const patience of [5, 61, 130, 200]) {
      const prover = createProver(ticking(1));
      const question = { file, run: null, terms: DEFAULT_TERMS } as const;
      expect(prover.prove({ ...question, patience }).limit).toBe('run');
      const done = prover.prove({ ...question, patience: 1e6 });
      expect(done.limit).toBeNull();
      expect(wayOf(done)).toEqual(full);
      // a shorter limit does not discard results
      expect(prover.prove({ ...question, patience: 1 })).toBe(done);
    }
  });

  itQuick('reports that other runs were not simulated', () => {
    const [first] = file.runs ?? [];
    const failing = { name: 'drift', holds: [] };
    const many = Array.from({ length: 300 }, (_, i) => ({ name: `r${i}`, holds: [[i, i + 1]] as [number, number][] }));
    const runs = [failing, ...many, { ...first, name: 'works' }];
    const hard = createEditedLevel({ ...file, runs }).file();
    const proof = createProver(ticking(1)).prove({ file: hard, run: 'drift', terms: DEFAULT_TERMS, patience: 2000 });
    expect(proof).toMatchObject({ limit: 'others', verdict: 'unproven', provenBy: null });
    expect(proof.full).not.toBeNull();
    expect(createProver().prove({ file: hard, run: 'drift', terms: DEFAULT_TERMS })).toMatchObject({
      limit: null,
      provenBy: 'works',
    });
  });

  it('is interrupted within a tick that takes too much work, and does not start if there is nothing to simulate', () => {
    const question = { file, run: null, terms: DEFAULT_TERMS, patience: 1e6 } as const;
    let cuts = 0;
    for (const work of [3, 10, 20, 40]) {
      const prover = createProver(() => 0, work);
      const cut = prover.prove(question);
      if (cut.limit === null) continue;
      cuts++;
      expect(cut).toMatchObject({ limit: 'run', verdict: 'unproven', full: null });
      expect(cut.run.way.count).toBeGreaterThan(0);
      const seen = STATE_SIZE * (cut.run.way.count - 1);
      expect(wayOf(cut).states.slice(0, seen)).toEqual(wayOf(whole()).states.slice(0, seen));
      expect([...cut.run.way.last].every(Number.isFinite)).toBe(true);
      // without a limit it is complete
      expect(wayOf(prover.prove({ ...question, patience: Number.POSITIVE_INFINITY }))).toEqual(wayOf(whole()));
    }
    expect(cuts).toBeGreaterThan(1);
    const crowd = createEditedLevel({
      ...file,
      aliens: Array.from({ length: 2000 }, (_, i) => ({
        id: `al${i}`,
        x: 40 * (i % 50),
        y: 2000 + 40 * Math.floor(i / 50),
        radius: 6,
      })),
    }).file();
    const prover = createProver(() => 0, 1);
    expect(prover.prove({ ...question, file: crowd })).toMatchObject({
      verdict: 'unproven',
      full: null,
      level: { aliens: { length: 2000 } },
    });
    // and back: both store their paths in the same arrays
    expect(wayOf(prover.prove({ ...question, patience: Number.POSITIVE_INFINITY }))).toEqual(wayOf(whole()));
    const other = createProver();
    const off = other.prove({ file, run: null, terms: DEFAULT_TERMS, patience: 0 });
    expect(off).toMatchObject({ limit: 'unchecked', verdict: 'unproven', problems: [{ code: 'work-limit' }] });
    expect([...off.run.way.states.subarray(0, 2)]).toEqual([file.astronaut.x, file.astronaut.y]);
    expect(wayOf(other.prove({ file, run: null, terms: DEFAULT_TERMS, patience: 1e6 }))).toEqual(wayOf(whole()));
  });
});
