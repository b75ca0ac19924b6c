import { ACCURACIES, type AccuracyName, DEFAULT_ACCURACY, TICK } from '../engine/index.ts';
import { type BenchScene, ORBIT, TWELVE_CIRCLES } from '../tests/scenes/index.ts';
import { ACCURACY_NAMES, atMost, type Contestant, compare, define } from './harness/index.ts';
import { loadPeers, type Peer, peerPlayer, simulatePeer } from './peers/index.ts';
import { referenceEnd } from './reference.ts';
import { replayer } from './replayer.ts';

const PEER_RATE = 60;
const REFERENCE_RATE = 3840;
const MINE = DEFAULT_ACCURACY;

interface Method {
  readonly name: string;
  readonly contestant: Contestant;
  /** Simulated time of one run of the contestant, s. */
  readonly seconds: number;
  /** Her place at the end of a scene, px; null if the run ended before. */
  end(scene: BenchScene): readonly [x: number, y: number] | null;
  readonly note: string;
}

function ours(name: AccuracyName): Method {
  const { simulation, run } = replayer(TWELVE_CIRCLES, name);
  run();
  return {
    name,
    contestant: { name, run },
    seconds: simulation.ending?.time ?? simulation.tick * TICK,
    note: ACCURACIES[name].contact === 'swept' ? 'contacts swept' : 'contacts once a step',
    end(scene) {
      const other = replayer(scene, name);
      other.run();
      return other.simulation.ending === null ? [other.state[0], other.state[1]] : null;
    },
  };
}

function theirs(peer: Peer): Method {
  return {
    name: peer.name,
    seconds: TWELVE_CIRCLES.seconds,
    contestant: { name: peer.name, ...peerPlayer(peer, TWELVE_CIRCLES, PEER_RATE) },
    note: `${PEER_RATE} Hz, ${peer.precision} precision, contacts once a step`,
    end(scene) {
      const run = simulatePeer(peer, scene.level, scene.holds, scene.seconds, PEER_RATE);
      const [, x, y] = run.samples[run.samples.length - 1];
      return run.outcome === null ? [x, y] : null;
    },
  };
}

export const bench = define({
  what: 'cost and error of every accuracy and of six other engines',
  options: {},
  claims: {
    costOfPeers: atMost(0.1, `cost of ${MINE} / of another engine`),
    costOfFast: atMost(1.15, `cost of ${MINE} / fast`),
    error: atMost(1e-3, `orbit error of ${MINE} / of another engine`),
  },
  async run() {
    const peers = await loadPeers();
    const methods = [...ACCURACY_NAMES.map(ours), ...peers.map(theirs)];
    const scenes = [ORBIT, TWELVE_CIRCLES];
    const endAt = (rate: number) => scenes.map(({ level, holds, seconds }) => referenceEnd(level, holds, seconds, rate));
    const references = endAt(REFERENCE_RATE);
    const doubts = endAt(REFERENCE_RATE / 2).map(([x, y], i) => Math.hypot(x - references[i][0], y - references[i][1]));
    const errors = methods.map((method) =>
      scenes.map((scene, i) => {
        const end = method.end(scene);
        return end === null ? null : Math.hypot(end[0] - references[i][0], end[1] - references[i][1]);
      }),
    );
    const measured = compare(
      methods.map((method) => method.contestant),
      { rounds: 21, sampleMs: 8, warmUpMs: 500 },
    );
    const seconds = Object.fromEntries(methods.map((method) => [method.name, method.seconds]));
    /** Cost per simulated second of `a` divided by that of `b`. */
    const ratio = (a: string, b: string): number => (measured.ratio(a, b).median * seconds[b]) / seconds[a];
    const orbitError = (name: string): number => errors[methods.findIndex((method) => method.name === name)][0] ?? Number.NaN;
    // Phaser Arcade and p2-es
    const rivals = peers.slice(0, 2).map(({ name }) => name);
    const of = (figure: (name: string) => number) => Object.fromEntries(rivals.map((name) => [name, figure(name)]));
    return {
      title: `Cost of a moving astronaut among 12 circles, and error after a minute (${TWELVE_CIRCLES.what})`,
      columns: ['', 'us a simulated second', `times ${MINE}`, 'error px, orbit', 'error px, twelve circles', ''],
      rows: methods.map((method, i) => [
        method.name,
        (1000 * measured.time(method.name).median) / method.seconds,
        ratio(method.name, MINE),
        ...errors[i],
        method.note,
      ]),
      measured: {
        costOfPeers: of((name) => ratio(MINE, name)),
        costOfFast: ratio(MINE, 'fast'),
        error: of((name) => orbitError(MINE) / orbitError(name)),
      },
      notes: [
        `Medians of ${measured.rounds} interleaved rounds; worlds are made outside the timing. '-': the run ended in a contact before its minute.`,
        `Errors against Runge-Kutta 4 at ${REFERENCE_RATE} Hz with target changes located; half its rate moves it by ` +
          scenes.map((scene, i) => `${doubts[i].toExponential(1)} px (${scene.name})`).join(' and ') +
          '. arcade answers a press one frame late, as the original did: most of its error is that.',
      ],
    };
  },
});
