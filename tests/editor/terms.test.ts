// Whatever a worker says of a level, it says under the terms that it is asked under.

import { describe, expect, it } from 'vitest';
import { brief, proveGoalImpossible } from '../../check/index.ts';
import type { JobKind, Requests, Results } from '../../editor/workers/index.ts';
import { JOBS } from '../../editor/workers/runner.ts';
import { ACCURACIES, compile, DEFAULT_TERMS, simulate, type Terms } from '../../engine/index.ts';
import { formatLevel, type Hold, type LevelFile, resolveLevel } from '../../schema/index.ts';
import { isDeep } from '../depth.ts';
import { GRAZE, SLOW } from './terms-levels.ts';

/** The terms of a test, and the level whose answer they change. */
const TERMS = {
  accuracy: { file: GRAZE, usual: DEFAULT_TERMS, other: { ...DEFAULT_TERMS, accuracy: ACCURACIES.arcade } },
  maxTime: { file: SLOW, usual: DEFAULT_TERMS, other: { ...DEFAULT_TERMS, maxTime: 120 } },
  maxWork: { file: GRAZE, usual: DEFAULT_TERMS, other: { ...DEFAULT_TERMS, maxWork: 3 } },
  rules: { file: GRAZE, usual: DEFAULT_TERMS, other: { ...DEFAULT_TERMS, rules: { pull: 60 } } },
} satisfies Readonly<Record<keyof Terms, { readonly file: LevelFile; readonly usual: Terms; readonly other: Terms }>>;

const levelOf = (file: LevelFile, terms: Terms) => resolveLevel(file, terms.rules);
const holdsOf = (file: LevelFile): readonly Hold[] => file.runs?.[0].holds ?? [];
const playedOf = (file: LevelFile, terms: Terms) => ({ level: levelOf(file, terms), terms });
const runOf = (file: LevelFile, terms: Terms) => ({ ...playedOf(file, terms), holds: holdsOf(file) });
const ANY = { minerals: 'any' } as const;
const LOOKS = { width: 100, theme: 'dark' } as const;

/** The file with its black hole out of the way. */
const brokenBy = (file: LevelFile): LevelFile => ({ ...file, blackHole: { ...file.blackHole, y: file.blackHole.y + 60 } });

/** What is asked of a kind of job, and whether its answer says that the run of the level completes it. */
interface Asked<K extends JobKind> {
  readonly ask: (file: LevelFile, terms: Terms) => Requests[K];
  readonly completes: (result: Results[K], file: LevelFile) => boolean;
  /** The terms on which its answer depends; left out: it has a limit of its own for the work, or is given what it would follow from. */
  readonly dependsOn: readonly (keyof Terms)[] | 'see below';
  /** The holds and the times of runs that it found; a replay under the same terms has to take as long to the last bit. */
  readonly found?: (result: Results[K]) => readonly { readonly holds: readonly Hold[]; readonly time: number }[];
  /** The job is stopped after so many steps: its answer is the last report. */
  readonly steps?: number;
}

const MOTION = ['accuracy', 'maxTime', 'rules'] as const;
const ALL = ['accuracy', 'maxTime', 'maxWork', 'rules'] as const;

const TABLE: { readonly [K in JobKind]: Asked<K> } = {
  solve: {
    ask: (file, terms) => ({
      ...playedOf(file, terms),
      ...{ goal: ANY, objective: 'robust', count: 1, seed: 1, lane: 0, budget: 5, known: [holdsOf(file)] },
    }),
    completes: ({ solutions }) => solutions.length > 0,
    dependsOn: ['maxTime'],
    found: ({ solutions }) => solutions,
  },
  robustness: {
    ask: (file, terms) => ({ ...runOf(file, terms), goal: ANY }),
    completes: ({ p40 }) => p40.p > 0,
    dependsOn: MOTION,
  },
  slack: {
    ask: (file, terms) => ({ ...runOf(file, terms), goal: ANY }),
    completes: (slack) => slack.some(({ earlier, later }) => earlier + later > 0),
    dependsOn: MOTION,
  },
  fan: {
    ask: (file, terms) => ({ ...runOf(file, terms), goal: ANY }),
    completes: ({ ways }) => ways.length > 0,
    dependsOn: MOTION,
  },
  difficulty: {
    ask: (file, terms) => ({ ...playedOf(file, terms), holds: null, goal: ANY, budget: 5 }),
    completes: (result) => result !== null,
    dependsOn: ['maxTime'],
  },
  grade: {
    ask: (file, terms) => ({ text: formatLevel(file), terms }),
    completes: (grade) => grade !== null,
    dependsOn: MOTION,
  },
  proofs: {
    ask: (file, terms) => ({ ...playedOf(file, terms), collected: [] }),
    completes: ({ impossible }) => impossible === null,
    dependsOn: 'see below',
  },
  accuracy: {
    ask: (file, terms) => {
      const { holds, ...played } = runOf(file, terms);
      return { ...played, runs: [holds], methods: 'named' as const };
    },
    completes: ([{ settings }]) => settings.some(({ outcome }) => outcome === 'completed'),
    dependsOn: ['maxTime', 'rules'],
  },
  effects: {
    ask: runOf,
    // arcade tells no effects apart
    completes: (timed) => timed !== null,
    dependsOn: ['accuracy'],
  },
  check: {
    ask: playedOf,
    completes: ({ ends }) => ends.some(({ outcome }) => outcome === 'completed'),
    dependsOn: ALL,
  },
  fix: {
    ask: (file, terms) => ({ ...playedOf(file, terms), seed: 0, budget: 10 }),
    completes: ({ completing }) => completing !== null,
    dependsOn: MOTION,
  },
  mend: {
    ask: (file, terms) => ({ before: file, after: brokenBy(file), terms, run: 'run', newRun: 'found' }),
    // a part of the change is taken back
    completes: ({ found }) => found.some(({ how }) => how.kind === 'back'),
    dependsOn: ['maxTime'],
    steps: 60,
  },
  thumbnail: {
    ask: (file, terms) => ({ text: formatLevel(file), terms, ...LOOKS }),
    completes: ({ verdict }) => verdict === 'completable',
    dependsOn: ALL,
  },
  compare: {
    ask: (file, terms) => ({ before: formatLevel(file), after: formatLevel({ ...file, name: 'Other' }), terms, ...LOOKS }),
    completes: ({ before }) => before.startsWith('completable'),
    dependsOn: ALL,
  },
  plays: {
    ask: (file, terms) => ({ ...playedOf(file, terms), plays: [], known: [], first: 0 }),
    // without plays, players are compared with a run of the level that completes it
    completes: ({ statistics }) => statistics.reference !== null,
    dependsOn: ALL,
  },
  lost: {
    ask: (file, terms) => ({ ...playedOf(file, terms), effort: 200_000 }),
    completes: ({ counts }) => counts.open > 0,
    dependsOn: ['accuracy', 'maxTime'],
  },
  losses: {
    ask: (file, terms) => ({ ...playedOf(file, terms), traced: [holdsOf(file)], effort: 1_000_000 }),
    completes: ({ losses: [loss] }) => loss.completes,
    dependsOn: MOTION,
  },
  leeway: {
    ask: (file, terms) => ({
      ...runOf(file, terms),
      ...{ objects: [{ kind: 'blackHole', index: 0 }], only: null, lead: file.blackHole, grid: null },
      seen: { left: file.blackHole.x, top: file.blackHole.y, right: file.blackHole.x + 4, bottom: file.blackHole.y + 4 },
    }),
    completes: ({ base }) => base === 'completes',
    dependsOn: MOTION,
    steps: 400,
  },
  retime: {
    ask: (file, terms) => ({
      ...runOf(file, terms),
      ...{ minerals: [], warm: null, within: 1, formerEnd: 5400, effort: 100_000, certifies: false },
    }),
    completes: ({ best }) => best !== null,
    dependsOn: ['maxTime'],
    found: ({ best }) => (best === null ? [] : [{ holds: best.holds, time: best.run.time }]),
  },
  path: {
    ask: (file, terms) => ({ ...runOf(file, terms), until: 600 }),
    // she is followed until she touches something
    completes: ({ points }) => points.length / 2 > 150,
    dependsOn: ['accuracy'],
  },
  trajectory: {
    ask: runOf,
    completes: ({ end }) => end.outcome === 'completed',
    dependsOn: MOTION,
  },
};

/** Does a job as a worker does, with a clock that goes on by a millisecond with each look. */
function answer<K extends JobKind>(kind: K, { ask, steps = 100_000 }: Asked<K>, file: LevelFile, terms: Terms): Results[K] {
  let clock = 0;
  const work = JOBS[kind](structuredClone(ask(file, terms)), () => clock++);
  let last: Results[K] | null = null;
  for (let i = 0; i < steps; i++) {
    const step = work.next();
    if (step.done === true) return step.value;
    if (step.value !== null) last = step.value as unknown as Results[K];
  }
  if (last === null) throw new Error(`${kind} has not said anything in ${steps} steps`);
  return last;
}

/** What `gq check` says: whether the run completes the level. */
const truth = (file: LevelFile, terms: Terms): boolean => brief(levelOf(file, terms), terms).verdict === 'completable';

describe('the terms of this test', () => {
  it.each(Object.entries(TERMS))('decide by %s whether the run completes the level', (_, { file, usual, other }) => {
    expect(truth(file, other)).toBe(!truth(file, usual));
  });
});

const termsOfKind = (kind: JobKind): readonly (keyof Terms)[] => {
  const { dependsOn } = TABLE[kind];
  return dependsOn === 'see below' ? [] : dependsOn;
};

/** Every kind of job under every term that it depends on; in the quick set under one of them, the kinds in turn. */
const rows = (Object.keys(JOBS) as JobKind[]).flatMap((kind, k) => {
  const terms = termsOfKind(kind);
  return (isDeep ? terms : terms.filter((_, i) => i === k % terms.length)).map((term) => [kind, term] as const);
});

it.each(rows)('%s answers under the terms it is asked under: %s', (kind, term) => {
  const { file, usual, other } = TERMS[term];
  const asked = TABLE[kind] as Asked<JobKind>;
  const says = (terms: Terms) => asked.completes(answer(kind, asked, file, terms) as never, file);
  expect([says(usual), says(other)]).toEqual([truth(file, usual), truth(file, other)]);
});

const finders = (Object.keys(JOBS) as JobKind[]).flatMap((kind) => (TABLE[kind].found === undefined ? [] : [kind]));

it.each(finders)('%s finds runs that take as long under the terms it is asked under', (kind) => {
  const asked = TABLE[kind] as Asked<JobKind>;
  for (const terms of [DEFAULT_TERMS, { ...DEFAULT_TERMS, accuracy: ACCURACIES.fast }]) {
    const level = levelOf(GRAZE, terms);
    const runs = asked.found?.(answer(kind, asked, GRAZE, terms) as never) ?? [];
    expect(runs).not.toEqual([]);
    for (const { holds, time } of runs) {
      expect(simulate(compile(level, terms), holds)).toMatchObject({ outcome: 'completed', time });
    }
  }
});

it('proofs hold under the terms they are asked under', () => {
  // the gun pulls her straight into a nova; that this is so is proved at `precise` only
  const trap: LevelFile = {
    ...{ version: 1, name: 'Trap', range: 400, astronaut: { x: 0, y: 0 }, blackHole: { x: 300, y: 0 } },
    asteroids: [{ id: 'a1', x: 60, y: 0, radius: 10 }],
    novae: [{ id: 'n1', x: 150, y: 0, radius: 60 }],
  };
  const others = [TERMS.accuracy.other, TERMS.maxTime.other];
  const proved = [DEFAULT_TERMS, ...others].map((terms) => answer('proofs', TABLE.proofs, trap, terms).impossible);
  expect(proved).toEqual(
    [DEFAULT_TERMS, ...others].map((terms) => proveGoalImpossible(compile(levelOf(trap, terms), terms), ANY)),
  );
  expect(proved.map((proof) => proof === null)).toEqual([false, true, false]);
});

it('asks every kind of job', () => {
  for (const kind of Object.keys(JOBS) as JobKind[]) expect(TABLE[kind]?.dependsOn, kind).not.toEqual([]);
});
