import type { RunEnd } from '../../../check/words/index.ts';
import { compile, maxTicksOf, type Scene, type Terms, TICK_RATE } from '../../../engine/index.ts';
import { createPlayer, type Player } from '../../../game/index.ts';
import type { Hold, Level } from '../../../schema/index.ts';
import type { Pose } from '../../core/context/index.ts';
import type { Replay } from '../../core/session/index.ts';
import { termsAt } from '../../core/terms/index.ts';

/** The longest frame that counts, ms; a longer one means that the tab slept or a debugger stopped it, and she waits. */
const LONGEST_FRAME = 250;

/** A person's attempt: the player, and what the editor shows and keeps of it. */
export interface Playtest extends Pick<ShownPlayer, 'pose' | 'moment'> {
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
}

/** How an attempt begins. */
interface PlaytestOptions {
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

/** What the canvas and the readout show of a player. */
interface ShownPlayer {
  /** Minerals that are collected, each counted once. */
  minerals(): number;
  /** px/s */
  speed(): number;
  /** The positions now, which may be between two ticks. */
  pose(): Pose;
  /** The tick of the positions, with a fraction. */
  moment(): number;
}

function showPlayer(player: Player): ShownPlayer {
  const { level } = player;
  const pose = new Float64Array(player.state.length);
  const aliens = level.aliens.length > 0 ? new Float64Array(3 * level.aliens.length) : null;
  const asteroids = level.recoil ? new Float64Array(2 * level.asteroids.length) : null;
  const taken = new Set<number>();
  let { events } = player;
  let read = 0;
  const collected = () => {
    // a restart begins another list
    if (player.events !== events || read > events.length) {
      events = player.events;
      read = 0;
      taken.clear();
    }
    for (; read < events.length; read++) {
      const event = events[read];
      if (event.type === 'mineral') taken.add(event.index);
    }
    return taken;
  };
  return {
    minerals: () => collected().size,
    // the pose lies between the last tick and the one before
    moment: () => (player.ending === null ? Math.max(0, player.tick - 1 + player.alpha) : player.tick),
    speed: () => Math.hypot(player.state[2], player.state[3]),
    pose() {
      player.readPose(pose);
      if (aliens !== null) player.readAliens(aliens);
      if (asteroids !== null) player.readAsteroids(asteroids);
      const [x, y, , , cos, sin] = pose;
      const target = player.ending === null ? player.target : null;
      const place = (index: number) =>
        asteroids === null ? level.asteroids[index] : { x: asteroids[2 * index], y: asteroids[2 * index + 1] };
      return { x, y, cos, sin, beamTo: target === null ? null : place(target), aliens, asteroids, collected: collected() };
    },
  };
}
