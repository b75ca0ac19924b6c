import { mkdirSync, writeFileSync } from 'node:fs';
import { basename, dirname, join } from 'node:path';
import { ACCURACIES, type Accuracy, DEFAULT_MAX_TICKS, TICK_RATE } from '../engine/index.ts';
import {
  type Cost,
  type Deviation,
  deviationOf,
  METHODS,
  measureCosts,
  type Path,
  type Player,
  playerOf,
  quantile,
  type Reference,
  referenceOf,
} from '../engine/work-precision/index.ts';
import {
  brief,
  type DiagramPoint,
  drawDiagram,
  drawTunnelling,
  linesOf,
  noteOf,
  type TunnellingCurve,
} from '../picture/accuracy/index.ts';
import type { Hold, Level } from '../schema/index.ts';
import { compareWith } from '../tests/judges/compare-with.ts';
import { missedContacts } from '../tests/judges/tunnelling.ts';
import { seeded } from '../tests/scenes/seeded.ts';
import { atMost, define, machine, PROJECT, packLevels, text } from './harness/index.ts';
import { buttonPerStep, loadPeers, type Peer, type PeerWorld, unsupportedIn } from './peers/index.ts';

/** Total time for timing, ms. */
const BUDGET = 20_000;
const PEER_BUDGET = 10_000;
const PEER_RATES = [60, 120, 240];
/** Flights past circles, by which contacts are counted that tests at frames miss. */
const SPEEDS = Array.from({ length: 20 }, (_, i) => 50 * (i + 1));
const RADII = [0.5, 1, 2, 4, 8, 16];
const FLIGHTS = 4000;

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

/** The runs of the shipped levels, or of one level file. */
function readScripts(file: string | null): Script[] {
  const one = file === null ? null : basename(file).replace('.level.json', '');
  const levels = file === null ? packLevels() : packLevels(dirname(file)).filter(({ name }) => name === one);
  const scripts = levels.flatMap(({ level }) =>
    level.runs.map(({ name, holds }) => ({ level, run: name, holds, reference: referenceOf(level, holds, DEFAULT_MAX_TICKS) })),
  );
  if (scripts.length === 0) throw new Error(`expected levels with runs, found none in ${file ?? 'levels'}`);
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
    code: peer.name,
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
    costSpread: [cost.minimum, cost.high],
    otherOutcomes: deviations.filter(({ sameVerdict }) => !sameVerdict).length,
  };
};

function changed(row: Row, scripts: readonly Script[]): string[] {
  return row.deviations.flatMap(({ sameVerdict, outcome }, i) =>
    sameVerdict ? [] : [`${scripts[i].level.name}, ${scripts[i].run}: ${outcome}, not ${scripts[i].reference.outcome}`],
  );
}

/** Every setting of ours and every peer at every rate, over all scripts. */
async function measureAll(scripts: readonly Script[], driven: readonly Script[]) {
  const ours = METHODS.map((accuracy) => ({
    accuracy,
    name: accuracy.name,
    deviations: scripts.map(({ level, holds, reference }) => compareWith(reference, level, holds, accuracy, DEFAULT_MAX_TICKS)),
  }));
  const ourCosts = measureCosts(
    METHODS.map((accuracy) => playerOf(scripts, accuracy, DEFAULT_MAX_TICKS)),
    () => performance.now(),
    { budget: BUDGET, most: Number.POSITIVE_INFINITY, sample: 1 },
  );
  const rows: (Row & { accuracy: Accuracy })[] = ours.map((row, i) => ({ ...row, cost: ourCosts[i] as Cost }));

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
    { budget: PEER_BUDGET, most: Number.POSITIVE_INFINITY, sample: 1 },
  );
  const peerRows = settings.map((setting, i) => ({ ...setting, deviations: peerDeviations[i], cost: peerCosts[i] as Cost }));
  return { rows, peers, peerRows };
}

/** Counts the contacts that tests at frames, and swept ones, miss of straight flights. */
function missed() {
  let swept = 0;
  const curves = RADII.map((radius): TunnellingCurve => {
    const points = SPEEDS.map((speed) => {
      const found = missedContacts(radius, speed, { rate: TICK_RATE, flights: FLIGHTS, random: seeded(1) });
      swept += found.swept;
      return [speed, found.frame / FLIGHTS] as const;
    });
    return { radius, points };
  });
  return { swept, curves };
}

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
      time: 0,
      words: `${row.name}: ${brief(error.median)} px in the median, ${brief(cost)} us a second of play`,
    };
  };
const ourPoint = (row: Row & { accuracy: Accuracy }): DiagramPoint =>
  point(
    ({ name }) => (Object.hasOwn(ACCURACIES, name) ? name : null),
    () => (row.accuracy.contact === 'swept' ? noteOf(row.accuracy) : null),
  )(row);
const settingOf = ({ integrator, rate, tolerance, contact }: Accuracy) => ({
  integrator,
  ...(rate === null ? { tolerance } : { rate }),
  contact,
});
const tableRow = (row: Row): (string | number)[] => {
  const { error, cost, otherOutcomes, runs } = summary(row);
  return [row.name, error.median, error.p90, error.worst, cost, `${otherOutcomes} of ${runs}`];
};

export const bench = define({
  what: 'error and cost of every accuracy over the shipped runs, written to docs/accuracy.json',
  options: { level: text('one level file instead of the shipped ones'), out: text('a folder instead of docs') },
  claims: {
    standard: atMost(1e-3, '90th percentile of the error of standard, px'),
    fast: atMost(0.5, '90th percentile of the error of fast, px'),
    missed: atMost(0, 'contacts the swept test missed'),
  },
  async run({ level, out: asked }) {
    const out = asked ?? join(PROJECT, 'docs');
    const scripts = readScripts(level);
    const driven = scripts.filter(isDrivable);
    const { rows, peers, peerRows } = await measureAll(scripts, driven);
    const { swept, curves } = missed();
    const known = scripts.flatMap(({ reference: { knownTo } }) => knownTo ?? []);
    const doubts = scripts.flatMap(({ level, run, reference: { doubt } }) =>
      doubt === null ? [] : [`${level.name}, ${run}: ${doubt}`],
    );
    const knownTo = Math.max(...known);
    const levels = new Set(scripts.map(({ level }) => level.name)).size;
    const typical = quantile(known, 0.5);
    const what = levels === 1 ? scripts[0].level.name : `${levels} levels`;
    const svg = drawDiagram({
      title: `What accuracy costs: ${what}, ${scripts.length} runs`,
      subtitle: [
        `Largest distance to a reference with 32 digits, known to ${brief(typical)} px: the median over runs.`,
        ...(peers.length > 0
          ? [`Other engines at ${PEER_RATES.join(', ')} Hz, on the ${driven.length} runs they can be driven through.`]
          : []),
      ],
      runs: scripts.length,
      floor: typical,
      used: null,
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
      sweptNote: swept === 0 ? 'swept: none missed at any speed' : `swept: ${swept} missed`,
    });

    mkdirSync(out, { recursive: true });
    writeFileSync(join(out, 'accuracy.svg'), svg);
    writeFileSync(join(out, 'tunnelling.svg'), tunnelling);
    const json = {
      machine: machine(),
      levels,
      runs: scripts.length,
      reference: { method: scripts[0].reference.method, knownTo: { median: typical, worst: knownTo }, doubts },
      methods: rows.map((row) => ({
        name: row.name,
        ...settingOf(row.accuracy),
        ...summary(row),
        changed: changed(row, scripts),
      })),
      peers: peerRows.map((row) => ({ name: row.peer.name, rate: row.rate, ...summary(row), changed: changed(row, driven) })),
      tunnelling: { rate: TICK_RATE, flights: FLIGHTS, sweptMissed: swept, curves },
    };
    writeFileSync(join(out, 'accuracy.json'), `${JSON.stringify(json, null, 2)}\n`);
    const p90 = (name: string): number => summary(rows.find((row) => row.name === name)!).error.p90;
    return {
      title: `What accuracy costs on ${what}, ${scripts.length} runs; pictures and every number in ${out}`,
      columns: ['', 'error px, median', '90 %', 'worst', 'us a simulated second', 'other outcomes'],
      rows: [...rows, ...peerRows].map(tableRow),
      measured: { standard: p90('standard'), fast: p90('fast'), missed: swept },
      notes: [
        `Errors are largest distances to the reference at ticks before the earlier end, whether or not the outcome is the same. ` +
          `Two references of different methods (${scripts[0].reference.method}, and series with isolated roots) differ by ${brief(typical)} px in the median and ${brief(knownTo)} px at worst. In doubt: ${doubts.join('; ') || 'none'}.`,
        `Outcomes change: ${rows.flatMap((row) => changed(row, scripts).map((text) => `${row.name}: ${text}`)).join('; ') || 'nowhere'}.`,
        `Tests at ${TICK_RATE} Hz miss up to ${Math.max(...curves.flatMap((c) => c.points.map(([, m]) => 100 * m))).toFixed(1)} % of the contacts of a flight below the speed limit; swept ones none of ${SPEEDS.length * RADII.length * FLIGHTS}.`,
        'Ninja, a tile-platformer engine without free bodies, can not be driven through a level.',
      ],
    };
  },
});
