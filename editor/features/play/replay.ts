import { compile, type Terms, TICK_RATE } from '../../../engine/index.ts';
import { createPlayer } from '../../../game/index.ts';
import type { Level } from '../../../schema/index.ts';
import type { Pose } from '../../core/context/index.ts';
import type { Replay } from '../../core/session/index.ts';
import { termsAt } from '../../core/terms/index.ts';
import { showPlayer } from './shown-player.ts';

/** A replay in progress. */
export interface ReplayPlayer {
  readonly tick: number;
  readonly isOver: boolean;
  readonly minerals: number;
  /** px/s */
  readonly speed: number;
  advance(ms: number): void;
  /** Goes to a tick, forwards or backwards. */
  seek(tick: number): void;
  pose(): Pose;
  /** The tick of the positions, with a fraction. */
  moment(): number;
}

/** Replays holds in a level, at the accuracy that they were played at. @param terms the others under which it is played */
export function createReplay(level: Level, terms: Terms, { holds, accuracy, tick: last }: Replay): ReplayPlayer {
  const player = createPlayer(compile(level, termsAt(terms, accuracy)), { replay: holds, maxTime: last / TICK_RATE });
  const shown = showPlayer(player);
  return {
    get tick() {
      return player.tick;
    },
    get isOver() {
      return player.ending !== null;
    },
    get minerals() {
      return shown.minerals();
    },
    get speed() {
      return shown.speed();
    },
    advance: (ms) => void player.advance(ms),
    seek: (tick) => player.restart({ from: tick > 0 ? { holds, tick } : null, replay: holds }),
    pose: shown.pose,
    moment: shown.moment,
  };
}
