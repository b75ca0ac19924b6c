import { ALIEN_PULL, ALIEN_SIGHT, EXPLOSION_FRAMES, GUN_PULL, REPULSOR_PUSH, SPEED_LIMIT, TICK } from '../constants.ts';
import { boxOverlapsCircle, circlesOverlap } from '../contact/index.ts';
import type { Scene } from '../scene.ts';
import type { BodyKind, Ending, Mode, Simulation, Work } from '../simulation.ts';
import type { FrameRecorder } from './recording.ts';

// Layout of the state: one typed array, so that a snapshot is one copy.
const FRAME = 0;
const HELD_FRAMES = 1;
const X = 2;
const Y = 3;
const VX = 4;
const VY = 5;
const AX = 6;
const AY = 7;
const COS = 8;
const SIN = 9;
const OUTCOME = 10;
const TOUCHED = 11;
const NEAREST = 12;
const FIELD = 13;
const MINERALS = 14;
const HEAD = 15;

// Per moving asteroid: place, velocity and acceleration. Kept only where the level has recoil.
const ROCK = 6;
// Per alien: the same, what it is up to, and this frame's displacement (stopping dead keeps it).
const ALIEN = 9;
const ASLEEP = 0;
const AWAKE = 1;
// An exploded alien holds FUSE + the frame in which it stops chasing.
const FUSE = 2;

// OUTCOME holds 0 while the run goes on, or one of these.
const LOST = 1;
const BLACK_HOLE = 2;
const NOVA = 3;
const ASTEROID = 4;
const ALIEN_TOUCH = 5;
const TOUCH_KIND: readonly (BodyKind | null)[] = [null, null, 'blackHole', 'nova', 'asteroid', 'alien'];

const clamp = (v: number): number => (v > SPEED_LIMIT ? SPEED_LIMIT : v < -SPEED_LIMIT ? -SPEED_LIMIT : v);

/**
 * The original game frame by frame, at 60 Hz, quirks included (accuracy `arcade`): semi-implicit Euler whose checks
 * see the positions of the frame before. Within a frame: velocities, then the gun and the checks on the old positions
 * (lost, completed, burned: the first counts), then aliens and repulsors set accelerations, then everything moves.
 */
export class ArcadeSimulation implements Simulation {
  readonly scene: Scene;
  private readonly s: Float64Array;
  private readonly start: Float64Array;
  private readonly rocks: number;
  private readonly aliens: number;
  private readonly minerals: number;
  private readonly recorder: FrameRecorder | null;

  constructor(scene: Scene, recorder: FrameRecorder | null = null) {
    this.scene = scene;
    this.recorder = recorder;
    const { targets, aliens, minerals } = scene;
    this.rocks = HEAD;
    this.aliens = this.rocks + (scene.level.recoil ? ROCK * targets.count : 0);
    this.minerals = this.aliens + ALIEN * aliens.count;
    this.start = new Float64Array(this.minerals + minerals.count);
    this.s = new Float64Array(this.start.length);
    this.layOut();
    this.reset();
  }

  private layOut(): void {
    const { level, targets, aliens } = this.scene;
    const s = this.start;
    s[X] = level.astronaut.x;
    s[Y] = level.astronaut.y;
    s[VX] = level.astronaut.vx;
    s[VY] = level.astronaut.vy;
    s[COS] = 1;
    s[NEAREST] = -1;
    s[FIELD] = -1;
    if (level.recoil) {
      for (let i = 0, o = this.rocks; i < targets.count; i++, o += ROCK) {
        s[o] = targets.x[i];
        s[o + 1] = targets.y[i];
      }
    }
    for (let i = 0, o = this.aliens; i < aliens.count; i++, o += ALIEN) {
      s[o] = aliens.x[i];
      s[o + 1] = aliens.y[i];
      if (circlesOverlap(s[X] - s[o], s[Y] - s[o + 1], ALIEN_SIGHT)) s[o + 6] = AWAKE;
    }
  }

  get tick(): number {
    return this.s[FRAME];
  }

  get work(): Work {
    const { targets, coldCount, novae, minerals, aliens } = this.scene;
    const pieces = this.s[FRAME];
    const circles = 1 + novae.count + (targets.count - coldCount) + minerals.count + aliens.count;
    return { pieces, forceEvaluations: this.s[HELD_FRAMES], guards: pieces * circles, roots: 0 };
  }

  get modes(): readonly Mode[] {
    const frames = this.s[FRAME];
    const held = this.s[HELD_FRAMES];
    const all = [
      { name: 'coast', share: (frames - held) / frames },
      { name: 'pull', share: held / frames },
    ];
    return all.filter(({ share }) => share > 0);
  }

  get mineralCount(): number {
    return this.s[MINERALS];
  }

  get ending(): Ending | null {
    const code = this.s[OUTCOME];
    if (code === 0) return null;
    const tick = this.s[FRAME] - 1;
    const kind = TOUCH_KIND[code];
    return {
      outcome: code === LOST ? 'lost' : code === BLACK_HOLE ? 'completed' : 'collided',
      with: kind === null ? null : { kind, index: this.s[TOUCHED] },
      time: tick * TICK,
      tick,
    };
  }

  reset(): void {
    this.s.set(this.start);
  }

  snapshot(into?: Float64Array): Float64Array {
    if (into === undefined || into.length !== this.s.length) return this.s.slice();
    into.set(this.s);
    return into;
  }

  restore(snapshot: Float64Array): void {
    if (snapshot.length !== this.s.length) {
      throw new RangeError(`expected a snapshot of ${this.s.length} numbers of this scene, found ${snapshot.length}`);
    }
    this.s.set(snapshot);
  }

  readState(out: Float64Array): void {
    const s = this.s;
    out[0] = s[X];
    out[1] = s[Y];
    out[2] = s[VX];
    out[3] = s[VY];
    out[4] = s[COS];
    out[5] = s[SIN];
  }

  readAliens(out: Float64Array): void {
    for (let i = 0, o = this.aliens; i < this.scene.aliens.count; i++, o += ALIEN) {
      out[3 * i] = this.s[o];
      out[3 * i + 1] = this.s[o + 1];
      out[3 * i + 2] = this.s[o + 6] < FUSE ? 1 : 0;
    }
  }

  readAsteroids(out: Float64Array): void {
    const { targets, level } = this.scene;
    for (let i = 0; i < targets.count; i++) {
      const k = 2 * targets.index[i];
      const o = this.rocks + ROCK * i;
      out[k] = level.recoil ? this.s[o] : targets.x[i];
      out[k + 1] = level.recoil ? this.s[o + 1] : targets.y[i];
    }
  }

  isCollected(mineral: number): boolean {
    return this.s[this.minerals + mineral] !== 0;
  }

  advance(ticks: number, held: boolean): number {
    const { s, scene, recorder } = this;
    const { targets, novae, repulsors, aliens, minerals, level } = scene;
    const { range, recoil } = level;
    const targetCount = targets.count;
    const tx = targets.x;
    const ty = targets.y;
    const novaCount = novae.count;
    const holeX = level.blackHole.x;
    const holeY = level.blackHole.y;
    const holeR = level.blackHole.radius;
    const coldCount = scene.coldCount;
    const rangeSquared = range * range;

    let frame = s[FRAME];
    const from = frame;
    let x = s[X];
    let y = s[Y];
    let vx = s[VX];
    let vy = s[VY];
    let ax = s[AX];
    let ay = s[AY];
    let cos = s[COS];
    let sin = s[SIN];
    let nearest = s[NEAREST];
    let outcome = s[OUTCOME];
    let touched = s[TOUCHED];
    const limit = outcome === 0 ? frame + ticks : frame;

    for (; frame < limit && outcome === 0; frame++) {
      // velocities and displacements; positions stay those of the frame before until the end of the frame
      vx = clamp(vx + ax * TICK);
      vy = clamp(vy + ay * TICK);
      const moveX = vx * TICK;
      const moveY = vy * TICK;
      if (recoil) this.accelerateRocks();
      if (aliens.count > 0) this.accelerateAliens();

      // the nearest asteroid; the first wins a tie
      let best = Number.POSITIVE_INFINITY;
      const before = nearest;
      nearest = -1;
      if (recoil) {
        for (let i = 0, o = this.rocks; i < targetCount; i++, o += ROCK) {
          const dx = s[o] - x;
          const dy = s[o + 1] - y;
          const d = dx * dx + dy * dy;
          if (d < best) {
            best = d;
            nearest = i;
          }
        }
      } else {
        for (let i = 0; i < targetCount; i++) {
          const dx = tx[i] - x;
          const dy = ty[i] - y;
          const d = dx * dx + dy * dy;
          if (d < best) {
            best = d;
            nearest = i;
          }
        }
      }
      if (best > rangeSquared) outcome = LOST;

      if (held && nearest >= 0) {
        const o = this.rocks + ROCK * nearest;
        const dx = (recoil ? s[o] : tx[nearest]) - x;
        const dy = (recoil ? s[o + 1] : ty[nearest]) - y;
        const d = Math.sqrt(best);
        // atan2(0, 0) is 0 in the original: at the very centre she turns to angle 0 and is pulled that way
        cos = d > 0 ? dx / d : 1;
        sin = d > 0 ? dy / d : 0;
        const pull = GUN_PULL * (1 - d / range);
        ax = pull * cos;
        ay = pull * sin;
        if (recoil) {
          const a = 1 / (2 * targets.r[nearest]);
          s[o + 4] = -a * cos;
          s[o + 5] = -a * sin;
        }
      } else {
        ax = 0;
        ay = 0;
        if (recoil && nearest >= 0) {
          const o = this.rocks + ROCK * nearest;
          s[o + 4] = 0;
          s[o + 5] = 0;
        }
      }
      if (recorder !== null) recorder.button(frame, held, nearest, before);

      // the checks, in the order of the original
      if (outcome === 0) {
        if (boxOverlapsCircle(holeX - x, holeY - y, cos, sin, holeR)) {
          outcome = BLACK_HOLE;
          touched = 0;
        }
        for (let i = 0; i < novaCount && outcome === 0; i++) {
          if (boxOverlapsCircle(novae.x[i] - x, novae.y[i] - y, cos, sin, novae.r[i])) {
            outcome = NOVA;
            touched = novae.index[i];
          }
        }
        for (let i = coldCount; i < targetCount && outcome === 0; i++) {
          const o = this.rocks + ROCK * i;
          const dx = (recoil ? s[o] : tx[i]) - x;
          const dy = (recoil ? s[o + 1] : ty[i]) - y;
          if (boxOverlapsCircle(dx, dy, cos, sin, targets.r[i])) {
            outcome = ASTEROID;
            touched = targets.index[i];
          }
        }
        if (minerals.count > 0) this.collectMinerals(frame, x, y, cos, sin);
        if (aliens.count > 0) {
          for (let i = 0, o = this.aliens; i < aliens.count && outcome === 0; i++, o += ALIEN) {
            if (boxOverlapsCircle(s[o] - x, s[o + 1] - y, cos, sin, aliens.r[i])) {
              outcome = ALIEN_TOUCH;
              touched = aliens.index[i];
            }
          }
          this.explodeAliens(frame);
        }
      }

      if (aliens.count > 0) this.chase(frame, x, y);

      // the first repulsor in the level's list wins an overlap
      let field = -1;
      for (let i = 0; i < repulsors.count; i++) {
        const dx = x - repulsors.x[i];
        const dy = y - repulsors.y[i];
        if (!circlesOverlap(dx, dy, repulsors.r[i])) continue;
        const d = Math.sqrt(dx * dx + dy * dy);
        ax = d > 0 ? (REPULSOR_PUSH * dx) / d : REPULSOR_PUSH;
        ay = d > 0 ? (REPULSOR_PUSH * dy) / d : 0;
        field = i;
        break;
      }
      if (field !== s[FIELD]) {
        if (recorder !== null) recorder.field(frame, s[FIELD], field);
        s[FIELD] = field;
      }

      if (outcome >= NOVA) {
        vx = 0;
        vy = 0;
      }
      x += moveX;
      y += moveY;
      if (recoil) this.placeRocks();
      if (aliens.count > 0) this.placeAliens();
      if (recorder !== null) {
        s[X] = x;
        s[Y] = y;
        s[VX] = vx;
        s[VY] = vy;
        s[COS] = cos;
        s[SIN] = sin;
        recorder.row(this);
        if (outcome !== 0)
          recorder.end(
            frame,
            outcome === LOST ? 'lost' : outcome === BLACK_HOLE ? 'completed' : 'collided',
            TOUCH_KIND[outcome],
            touched,
          );
      }
    }

    s[FRAME] = frame;
    if (held) s[HELD_FRAMES] += frame - from;
    s[X] = x;
    s[Y] = y;
    s[VX] = vx;
    s[VY] = vy;
    s[AX] = ax;
    s[AY] = ay;
    s[COS] = cos;
    s[SIN] = sin;
    s[OUTCOME] = outcome;
    s[TOUCHED] = touched;
    s[NEAREST] = nearest;
    return frame - from;
  }

  private accelerateRocks(): void {
    const s = this.s;
    for (let i = 0, o = this.rocks; i < this.scene.targets.count; i++, o += ROCK) {
      s[o + 2] = clamp(s[o + 2] + s[o + 4] * TICK);
      s[o + 3] = clamp(s[o + 3] + s[o + 5] * TICK);
    }
  }

  private placeRocks(): void {
    const s = this.s;
    for (let i = 0, o = this.rocks; i < this.scene.targets.count; i++, o += ROCK) {
      s[o] += s[o + 2] * TICK;
      s[o + 1] += s[o + 3] * TICK;
    }
  }

  private accelerateAliens(): void {
    const s = this.s;
    for (let i = 0, o = this.aliens; i < this.scene.aliens.count; i++, o += ALIEN) {
      s[o + 2] = clamp(s[o + 2] + s[o + 4] * TICK);
      s[o + 3] = clamp(s[o + 3] + s[o + 5] * TICK);
      s[o + 7] = s[o + 2] * TICK;
      s[o + 8] = s[o + 3] * TICK;
    }
  }

  private placeAliens(): void {
    const s = this.s;
    for (let i = 0, o = this.aliens; i < this.scene.aliens.count; i++, o += ALIEN) {
      s[o] += s[o + 7];
      s[o + 1] += s[o + 8];
    }
  }

  /** Of several minerals touched in one frame all are counted, but only the last is taken away: a slip of the original. */
  private collectMinerals(frame: number, x: number, y: number, cos: number, sin: number): void {
    const { s, scene, recorder } = this;
    const { minerals } = scene;
    let last = -1;
    for (let i = 0; i < minerals.count; i++) {
      if (s[this.minerals + i] !== 0) continue;
      if (!boxOverlapsCircle(minerals.x[i] - x, minerals.y[i] - y, cos, sin, minerals.r[i])) continue;
      s[MINERALS]++;
      last = i;
      if (recorder !== null) recorder.mineral(frame, i);
    }
    if (last >= 0) s[this.minerals + last] = 1;
  }

  private explodeAliens(frame: number): void {
    const { s, scene, recorder } = this;
    const { aliens } = scene;
    for (let i = 0; i < aliens.count; i++) {
      const a = this.aliens + ALIEN * i;
      for (let j = i + 1; j < aliens.count; j++) {
        const b = this.aliens + ALIEN * j;
        if (s[a + 6] >= FUSE || s[b + 6] >= FUSE) continue;
        if (!circlesOverlap(s[a] - s[b], s[a + 1] - s[b + 1], aliens.r[i] + aliens.r[j])) continue;
        s[a + 6] = FUSE + frame + EXPLOSION_FRAMES;
        s[b + 6] = FUSE + frame + EXPLOSION_FRAMES;
        if (recorder !== null) recorder.explosion(frame, i, j);
      }
    }
  }

  /** Sets the aliens' accelerations; an exploded one goes on until its fuse is out: a slip of the original. */
  private chase(frame: number, x: number, y: number): void {
    const { s, scene, recorder } = this;
    for (let i = 0, o = this.aliens; i < scene.aliens.count; i++, o += ALIEN) {
      const dx = x - s[o];
      const dy = y - s[o + 1];
      const d = Math.sqrt(dx * dx + dy * dy);
      const state = s[o + 6];
      const exploded = state >= FUSE;
      const awake = d < ALIEN_SIGHT && !(exploded && frame >= state - FUSE);
      if (awake) {
        s[o + 4] = d > 0 ? (ALIEN_PULL * dx) / d : ALIEN_PULL;
        s[o + 5] = d > 0 ? (ALIEN_PULL * dy) / d : 0;
      } else {
        s[o + 2] = 0;
        s[o + 3] = 0;
        s[o + 4] = 0;
        s[o + 5] = 0;
      }
      if (exploded || awake === (state === AWAKE)) continue;
      s[o + 6] = awake ? AWAKE : ASLEEP;
      if (recorder !== null) recorder.alien(frame, i, awake);
    }
  }
}
