import { mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { brief } from '../cli/accuracy/index.ts';
import { ACCURACIES, type Accuracy, DEFAULT_MAX_TICKS, TICK_RATE } from '../engine/index.ts';
import {
  type Cost,
  compareWith,
  type Deviation,
  deviationOf,
  METHODS,
  measureCosts,
  missedContacts,
  type Path,
  type Player,
  playerOf,
  quantile,
  REFERENCE_TOLERANCE,
  type Reference,
  referenceOf,
} from '../engine/work-precision/index.ts';
import {
  type DiagramPoint,
  drawDiagram,
  drawTunnelling,
  linesOf,
  noteOf,
  type TunnellingCurve,
} from '../picture/accuracy/index.ts';
import { type Hold, type Level, readLevel } from '../schema/index.ts';
import { seeded } from '../tests/scenes/seeded.ts';
import { atMost, machine, optionValue, publish } from './harness.ts';
import { buttonPerStep, loadPeers, type Peer, type PeerWorld, unsupportedIn } from './peers/index.ts';

const PROJECT = fileURLToPath(new URL('../../', import.meta.url));
const OUT = optionValue('--out') ?? join(PROJECT, 'docs');
/** Total time for timing, ms. */
const BUDGET = 20_000;
const PEER_BUDGET = 10_000;
const PEER_RATES = [60, 120, 240];

interface Script {
  readonly level: Level;
  readonly run: string;
  readonly holds: readonly Hold[];
  readonly reference: Reference;
}

/** The results of a setting, or of a peer at a rate, over all scripts. */
interface Row {
  readonly name: string;
  readonly deviations: readonly Deviation[];
  readonly cost: Cost;
}

function readScripts(): Script[] {
  const one = optionValue('--level');
  const pack = join(PROJECT, 'levels');
  const files =
    one !== null
      ? [one]
      : readdirSync(pack)
          .filter((name) => name.endsWith('.level.json'))
          .sort()
          .map((name) => join(pack, name));
  const scripts = files.flatMap((file) => {
    const read = readLevel(readFileSync(file));
    if (!read.ok) throw new Error(`expected a valid level in ${file}: ${read.problems[0].message}`);
    const { level } = read;
    return level.runs.map(({ name, holds }) => ({
      level,
      run: name,
      holds,
      reference: referenceOf(level, holds, DEFAULT_MAX_TICKS),
    }));
  });
  if (scripts.length === 0) throw new Error(`expected levels with runs, found none in ${one ?? pack}`);
  return scripts;
}

/** Steps a peer through a script: its path at the ticks, up to the first outcome that its own contacts report. */
function peerPath(world: PeerWorld, { holds }: Script, rate: number): Path {
  const button = buttonPerStep(holds, (DEFAULT_MAX_TICKS * rate) / TICK_RATE, rate);
  const state = new Float64Array(4);
  const x: number[] = [];
  const y: number[] = [];
  let step = 0;
  for (; step < button.length && world.outcome === null; step++) {
    if ((step * TICK_RATE) % rate === 0) {
      world.read(state);
      x.push(state[0]);
      y.push(state[1]);
    }
    world.step(button[step] === 1);
  }
  const { outcome } = world;
  const ending =
    outcome === null ? null : { outcome, with: null, time: step / rate, tick: Math.floor((step * TICK_RATE) / rate) };
  return { count: x.length, x: Float64Array.from(x), y: Float64Array.from(y), ending };
}

/** Plays all scripts in a peer's worlds, which are created outside the timing. */
function peerPlayer(peer: Peer, rate: number, scripts: readonly Script[]): Player {
  const buttons = scripts.map(({ holds }) => buttonPerStep(holds, (DEFAULT_MAX_TICKS * rate) / TICK_RATE, rate));
  let worlds: PeerWorld[] = [];
  return {
    prepare() {
      for (const world of worlds) world.dispose();
      worlds = scripts.map(({ level }) => peer.create(level, rate));
    },
    play() {
      let steps = 0;
      for (const [i, world] of worlds.entries()) {
        const button = buttons[i];
        let step = 0;
        for (; step < button.length && world.outcome === null; step++) world.step(button[step] === 1);
        steps += step;
      }
      return steps / rate;
    },
  };
}

const isDrivable = ({ level }: Script): boolean => unsupportedIn(level).length === 0;

const summary = ({ deviations, cost }: Row) => {
  const errors = deviations.map(({ error }) => error);
  return {
    runs: deviations.length,
    error: { median: quantile(errors, 0.5), p90: quantile(errors, 0.9), worst: quantile(errors, 1) },
    cost: cost.minimum,
    medianCost: cost.median,
    otherOutcomes: deviations.filter(({ sameVerdict }) => !sameVerdict).length,
  };
};

function changed(row: Row, scripts: readonly Script[]): string[] {
  return row.deviations.flatMap(({ sameVerdict, outcome }, i) =>
    sameVerdict ? [] : [`${scripts[i].level.name}, ${scripts[i].run}: ${outcome}, not ${scripts[i].reference.outcome}`],
  );
}

const scripts = readScripts();
const ours = METHODS.map((accuracy) => ({
  accuracy,
  name: accuracy.name,
  deviations: scripts.map(({ level, holds, reference }) => compareWith(reference, level, holds, accuracy, DEFAULT_MAX_TICKS)),
}));
const ourCosts = measureCosts(
  METHODS.map((accuracy) => playerOf(scripts, accuracy, DEFAULT_MAX_TICKS)),
  () => performance.now(),
  { budget: BUDGET, sample: 1 },
);
const rows: (Row & { accuracy: Accuracy })[] = ours.map((row, i) => ({ ...row, cost: ourCosts[i] }));

const driven = scripts.filter(isDrivable);
const peers = driven.length === 0 ? [] : await loadPeers();
const settings = peers.flatMap((peer) => PEER_RATES.map((rate) => ({ peer, rate, name: `${peer.name} ${rate} Hz` })));
const peerDeviations = settings.map(({ peer, rate }) =>
  driven.map((script) => {
    const world = peer.create(script.level, rate);
    const path = peerPath(world, script, rate);
    world.dispose();
    return deviationOf(path, script.reference, DEFAULT_MAX_TICKS);
  }),
);
const peerCosts = measureCosts(
  settings.map(({ peer, rate }) => peerPlayer(peer, rate, driven)),
  () => performance.now(),
  { budget: PEER_BUDGET, sample: 1 },
);
const peerRows = settings.map((setting, i) => ({ ...setting, deviations: peerDeviations[i], cost: peerCosts[i] }));

const SPEEDS = Array.from({ length: 20 }, (_, i) => 50 * (i + 1));
const RADII = [0.5, 1, 2, 4, 8, 16];
const FLIGHTS = 4000;
let sweptMissed = 0;
const curves = RADII.map((radius): TunnellingCurve => {
  const points = SPEEDS.map((speed) => {
    const missed = missedContacts(radius, speed, { rate: TICK_RATE, flights: FLIGHTS, random: seeded(1) });
    sweptMissed += missed.swept;
    return [speed, missed.frame / FLIGHTS] as const;
  });
  return { radius, points };
});

const floor = Math.max(...scripts.map(({ reference }) => reference.floor));
const levels = new Set(scripts.map(({ level }) => level.name)).size;
const point =
  (label: (row: Row) => string | null, note: (row: Row) => string | null) =>
  (row: Row): DiagramPoint => {
    const { error, cost, otherOutcomes, runs } = summary(row);
    return {
      error: error.median,
      worseError: runs > 1 ? error.p90 : null,
      cost,
      failures: otherOutcomes,
      label: label(row),
      note: note(row),
    };
  };
const ourPoint = (row: Row & { accuracy: Accuracy }): DiagramPoint =>
  point(
    ({ name }) => (Object.hasOwn(ACCURACIES, name) ? name : null),
    () => (row.accuracy.contact === 'swept' ? noteOf(row.accuracy) : null),
  )(row);
const typicalFloor = quantile(
  scripts.map(({ reference }) => reference.floor),
  0.5,
);
const what = levels === 1 ? scripts[0].level.name : `${levels} levels`;
const svg = drawDiagram({
  title: `What accuracy costs: ${what}, ${scripts.length} runs`,
  subtitle: [
    `Largest distance to a run at tolerance ${REFERENCE_TOLERANCE.toExponential()} px, known to ${brief(typicalFloor)} px: the median over runs.`,
    ...(peers.length > 0
      ? [`Other engines at ${PEER_RATES.join(', ')} Hz, on the ${driven.length} runs they can be driven through.`]
      : []),
  ],
  runs: scripts.length,
  floor: typicalFloor,
  lines: [
    ...linesOf(rows, ourPoint),
    ...peers.map((peer) => ({
      name: peer.name,
      kind: 'peer' as const,
      faint: false,
      points: peerRows
        .filter((row) => row.peer === peer)
        .map((row) =>
          point(
            () => (row.rate === PEER_RATES[0] ? peer.name : null),
            () => null,
          )(row),
        ),
    })),
  ],
});
const tunnelling = drawTunnelling({
  title: `Contacts that a test at ${TICK_RATE} frames a second misses`,
  subtitle: `Of ${FLIGHTS} straight flights that touch a circle of radius r px, at random angles and offsets`,
  curves,
  sweptNote: sweptMissed === 0 ? 'swept: none missed at any speed' : `swept: ${sweptMissed} missed`,
});

mkdirSync(OUT, { recursive: true });
writeFileSync(join(OUT, 'accuracy.svg'), svg);
writeFileSync(join(OUT, 'tunnelling.svg'), tunnelling);
const setting = ({ integrator, rate, tolerance, contact }: Accuracy) => ({
  integrator,
  ...(rate === null ? { tolerance } : { rate }),
  contact,
});
const json = {
  machine: machine(),
  levels,
  runs: scripts.length,
  reference: { tolerance: REFERENCE_TOLERANCE, floor: { median: typicalFloor, worst: floor } },
  methods: rows.map((row) => ({ name: row.name, ...setting(row.accuracy), ...summary(row), changed: changed(row, scripts) })),
  peers: peerRows.map((row) => ({ name: row.peer.name, rate: row.rate, ...summary(row), changed: changed(row, driven) })),
  tunnelling: { rate: TICK_RATE, flights: FLIGHTS, sweptMissed, curves },
};
writeFileSync(join(OUT, 'accuracy.json'), `${JSON.stringify(json, null, 2)}\n`);

const named = rows.filter(({ name }) => Object.hasOwn(ACCURACIES, name));
const tableRow = (row: Row): (string | number)[] => {
  const { error, cost, otherOutcomes, runs } = summary(row);
  return [row.name, error.median, error.p90, error.worst, cost, `${otherOutcomes} of ${runs}`];
};
const p90 = (name: string): number => summary(named.find((row) => row.name === name)!).error.p90;
publish({
  title: `What accuracy costs on ${what}, ${scripts.length} runs; pictures and every number in ${OUT}`,
  columns: ['', 'error px, median', '90 %', 'worst', 'us a simulated second', 'other outcomes'],
  rows: [...rows, ...peerRows].map(tableRow),
  claims: [
    atMost('90th percentile of the error of standard, px', p90('standard'), 1e-3),
    atMost('90th percentile of the error of fast, px', p90('fast'), 0.5),
    atMost('contacts the swept test missed', sweptMissed, 0),
  ],
  notes: [
    `Errors are largest distances to the reference at ticks before the earlier end, whether or not the outcome is the same. ` +
      `The reference (taylor, ${REFERENCE_TOLERANCE.toExponential()} px) moves by ${brief(typicalFloor)} px in the median and ${brief(floor)} px at worst when its tolerance is 3 or 10 times looser.`,
    `Outcomes change: ${rows.flatMap((row) => changed(row, scripts).map((text) => `${row.name}: ${text}`)).join('; ') || 'nowhere'}.`,
    `Tests at ${TICK_RATE} Hz miss up to ${Math.max(...curves.flatMap((c) => c.points.map(([, m]) => 100 * m))).toFixed(1)} % of the contacts of a flight below the speed limit; swept ones none of ${SPEEDS.length * RADII.length * FLIGHTS}.`,
    'Ninja, a tile-platformer engine without free bodies, can not be driven through a level.',
  ],
});
