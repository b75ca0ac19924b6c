import type { RunEnd } from '../../../check/words/index.ts';
import { maxTicksOf, type Scene } from '../../../engine/index.ts';
import { createPlayer, type Player } from '../../../game/index.ts';
import type { Hold } from '../../../schema/index.ts';
import type { Pose } from '../../core/context/index.ts';
import { showPlayer } from './shown-player.ts';

/** The longest frame that counts, ms; a longer one means that the tab slept or a debugger stopped it, and she waits. */
const LONGEST_FRAME = 250;

/** A person's attempt: the player, and what the editor shows and keeps of it. */
export interface Playtest {
  readonly player: Player;
  /** The tick at which the user takes over; before it the run's own holds are played. */
  readonly startTick: number;
  /** null while the attempt lasts */
  readonly end: RunEnd | null;
  /** Minerals that are collected, each counted once. */
  readonly minerals: number;
  /** px/s */
  readonly speed: number;
  /** x, y at every tick so far, px */
  points(): Float32Array;
  /** The positions now, which may be between two ticks. */
  pose(): Pose;
  /** The tick of the positions, with a fraction. */
  moment(): number;
}

/** How an attempt begins. */
export interface PlaytestOptions {
  /** The run whose beginning is played first, and the tick at which the user takes over; null: from the start. */
  readonly from: { readonly holds: readonly Hold[]; readonly tick: number } | null;
  /** Called for each mineral that the user collects. */
  readonly onMineral?: () => void;
  /** Called once when the attempt has ended. */
  readonly onEnd?: (playtest: Playtest) => void;
}

/** Starts an attempt. */
export function createPlaytest(scene: Scene, { from, onMineral, onEnd }: PlaytestOptions): Playtest {
  const track: number[] = [];
  const see = () => track.push(player.state[0], player.state[1]);
  const player: Player = createPlayer(scene, {
    maxTime: scene.terms.maxTime,
    maxFrame: LONGEST_FRAME,
    onTick: see,
    onEvent: ({ event }) => event.type === 'mineral' && onMineral?.(),
    onEnd: () => onEnd?.(playtest),
  });
  see();
  // not at once, as the ticks before are seen, too
  if (from !== null) player.restart({ from: { ...from, tick: Math.round(Math.min(maxTicksOf(scene.terms), from.tick)) } });
  const shown = showPlayer(player);
  const playtest: Playtest = {
    player,
    startTick: player.tick,
    get end() {
      return player.ending;
    },
    get minerals() {
      return shown.minerals();
    },
    get speed() {
      return shown.speed();
    },
    points: () => Float32Array.from(track),
    pose: shown.pose,
    moment: shown.moment,
  };
  return playtest;
}
