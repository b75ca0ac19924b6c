import { TWELVE_CIRCLES } from '../tests/scenes/index.ts';
import { atMost, compare, define, timeCells } from './harness/index.ts';
import { peerPlayer } from './peers/index.ts';
import { phaserArcade } from './peers/phaser-arcade.ts';
import { type PlainState, plainLoop, plainScene } from './plain-loop.ts';
import { lasting } from './replayer.ts';

const { level, holds, seconds, what } = TWELVE_CIRCLES;
const TICKS = seconds * 60;
const ENGINE = 'arcade';
const PLAIN = 'plain loop';

export const bench = define({
  what: 'arcade frames against a hand-written loop and Phaser Arcade',
  options: {},
  claims: {
    plain: atMost(1.3, 'arcade / plain loop'),
    phaser: atMost(1 / 5, `arcade / ${phaserArcade.name}`),
  },
  async run() {
    const engine = lasting(TWELVE_CIRCLES, 'arcade', 'twelve circles');
    const scene = plainScene(level, holds);
    const out: PlainState = { frame: 0, outcome: 0, x: 0, y: 0, vx: 0, vy: 0, cos: 0, sin: 0 };
    const plain = () => {
      plainLoop(scene, TICKS, out);
      return out.x + out.y;
    };
    // the loop is a fair yardstick only if it does the same work: the same frames, the same bits
    plain();
    const [x, y, vx, vy, cos, sin] = engine.state;
    const different = Object.entries({ frame: engine.simulation.tick, outcome: 0, x, y, vx, vy, cos, sin }).filter(
      ([key, value]) => !Object.is(value, out[key as keyof PlainState]),
    );
    if (different.length > 0) {
      throw new Error(`the plain loop and the engine disagree in ${different.map(([key]) => key).join(', ')}`);
    }
    await phaserArcade.load();
    const measured = compare(
      [
        { name: ENGINE, run: engine.run },
        { name: PLAIN, run: plain },
        { name: phaserArcade.name, ...peerPlayer(phaserArcade, TWELVE_CIRCLES, 60) },
      ],
      { rounds: 51, sampleMs: 12, warmUpMs: 800 },
    );
    return {
      title: `One minute of play: ${what}`,
      columns: ['', 'ms a minute', 'quartiles', 'us a simulated second', 'times the plain loop'],
      rows: [ENGINE, PLAIN, phaserArcade.name].map((name) => {
        const cells = timeCells(measured, name, 3);
        return [...cells, (1000 * cells[1]) / seconds, measured.ratio(name, PLAIN).median];
      }),
      measured: {
        plain: measured.ratio(ENGINE, PLAIN).median,
        phaser: measured.ratio(ENGINE, phaserArcade.name).median,
      },
      notes: [`Medians of ${measured.rounds} interleaved rounds. Engine and plain loop end in the same bits.`],
    };
  },
});
