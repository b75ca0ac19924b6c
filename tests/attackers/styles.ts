import { type Level, NO_OBJECTS } from '../../schema/index.ts';
import type { PROVERS } from '../../solver/index.ts';

export type Prover = keyof typeof PROVERS;
type Asteroid = Level['asteroids'][number];
type Circle = Level['novae'][number];

/** Random choices for a level. */
class Dice {
  private readonly random: () => number;

  constructor(random: () => number) {
    this.random = random;
  }

  between(a: number, b: number): number {
    return a + (b - a) * this.random();
  }

  chance(p: number): boolean {
    return this.random() < p;
  }

  pick<T>(...of: readonly T[]): T {
    return of[Math.floor(this.random() * of.length)];
  }

  upTo(most: number): number {
    return Math.floor(this.random() * (most + 1));
  }
}

const circle = (x: number, y: number, radius: number): Circle => ({ id: null, x, y, radius });
const rock = (x: number, y: number, radius: number, hot = false): Asteroid => ({ ...circle(x, y, radius), hot });

/** A circle far from everything. */
export const AWAY = { id: null, x: 0, y: 3e7, radius: 18 };

const EMPTY: Level = {
  name: 'attacked',
  description: '',
  astronaut: { x: 0, y: 0, vx: 0, vy: 0 },
  blackHole: AWAY,
  range: 250,
  recoil: false,
  ...NO_OBJECTS,
  runs: [],
};

/**
 * A level for which one of the provers finds proofs. Nothing is claimed yet: the black hole and minerals are added later at
 * places where she was or was not.
 */
export function levelFor(prover: Prover, random: () => number): Level {
  const dice = new Dice(random);
  const level = turned(MAKERS[prover](dice), dice);
  return dice.chance(0.1) ? moved(level, dice.pick(1000, -4321.1, 2 ** 17), dice.between(-5000, 5000)) : level;
}

const MAKERS: Readonly<Record<Prover, (dice: Dice) => Level>> = {
  'nothing-in-range': (d) => {
    const range = d.pick(100, 250, 1000);
    // beyond the range by the smallest detectable amount, or within it
    const off = d.pick(-1e-5, -1e-3, 1e-5, 1e-3, 0.1, 10);
    return {
      ...EMPTY,
      range,
      asteroids: d.chance(0.1) ? [] : [rock(range + off, 0, 16)],
      astronaut: start(d, d.pick(0, 0, 200)),
    };
  },
  'starts-in-hazard': (d) => {
    const deep = d.pick(0.001, 0.1, 3);
    const r = d.pick(5, 16, 32);
    const turn = d.between(0, 6.3);
    const far = r + d.pick(9.9, 10, 13, 16, 18.8) - deep;
    const nova = circle(far * Math.cos(turn), far * Math.sin(turn), r);
    return {
      ...EMPTY,
      asteroids: [rock(d.between(60, 200), 0, 16)],
      astronaut: start(d, d.pick(0, 0, 100)),
      ...(d.chance(0.3) ? { aliens: [nova, ...(d.chance(0.5) ? [circle(nova.x + r, nova.y, r)] : [])] } : { novae: [nova] }),
    };
  },
  'out-of-range': (d) => {
    const range = d.pick(60, 120, 250, 1000);
    const asteroids = [rock(d.between(0.1, 0.8) * range, 0, 16)];
    const frames = d.between(0, 6);
    // a chain of ranges that touch, overlap a little, or leave a gap that a frame may jump
    for (let n = d.upTo(3); n >= 0; n--) {
      const last = asteroids[asteroids.length - 1];
      asteroids.push(
        rock(last.x + 2 * range + d.pick(-20, -1, -0.01, 0.01, frames, frames, 30), last.y + d.between(-1, 1), d.pick(1, 16)),
      );
    }
    const speed = d.pick(0, 50, 200, 700);
    return {
      ...EMPTY,
      range,
      asteroids,
      recoil: d.chance(0.2),
      astronaut: { x: 0, y: 0, vx: speed, vy: d.between(-0.1, 0.1) * speed },
    };
  },
  'line-trap': (d) => onLine(d),
  'dead-end': (d) => {
    const near = rock(d.between(40, 90), 0, d.pick(16, 32));
    const others = Array.from({ length: 1 + d.upTo(1) }, () =>
      rock(d.between(100, 220), d.between(-130, 130), 16, d.chance(0.2)),
    );
    const novae = [
      circle(d.between(-90, -50), d.between(-20, 20), 24),
      circle(d.between(130, 260), d.between(-20, 20), 32),
      ...Array.from({ length: 2 + d.upTo(7) }, () => circle(d.between(80, 260), d.between(-140, 140), 32)),
    ];
    const repulsors = d.chance(0.2) ? [circle(d.between(80, 260), d.between(-140, 140), d.pick(32, 48))] : [];
    return { ...EMPTY, asteroids: [near, ...others], novae, repulsors };
  },
  doomed: (d) => (d.chance(0.8) ? wall(d) : moving(d, false)),
  flowpipe: (d) => moving(d, true),
  orbits: (d) => orbiting(d),
  covered: (d) => ({
    ...EMPTY,
    asteroids: [rock(d.between(60, 160), 0, 16), rock(d.between(-100, 200), d.between(80, 200), 16)],
    astronaut: start(d, d.pick(0, 40, 200)),
    recoil: d.chance(0.2),
  }),
  enclosed: (d) => {
    const inside = d.chance(0.5);
    const r = d.between(60, 160);
    const [x, y] = inside ? [0, 0] : [d.between(150, 260), d.between(-40, 40)];
    const size = d.pick(16, 16, 32);
    const count = Math.ceil((2 * Math.PI * r) / (2 * size + d.between(-6, 19.9)));
    const gap = d.chance(0.3) ? 1 + d.upTo(1) : 0;
    const novae = Array.from({ length: Math.max(3, count - gap) }, (_, i) => {
      const turn = (2 * Math.PI * (i + 0.5)) / count;
      return circle(x + r * Math.cos(turn), y + r * Math.sin(turn), size);
    });
    return {
      ...EMPTY,
      range: d.pick(250, 250, 400),
      asteroids: [rock(d.between(20, 50), d.between(-10, 10), 8), rock(d.between(-200, 200), d.between(-200, 200), 16)],
      astronaut: start(d, d.pick(0, 20, 300)),
      novae: novae.filter((nova) => Math.hypot(nova.x, nova.y) > size + 20),
    };
  },
};

function start(dice: Dice, speed: number): Level['astronaut'] {
  const turn = dice.between(0, 6.3);
  return { x: 0, y: 0, vx: speed * Math.cos(turn), vy: speed * Math.sin(turn) };
}

/** At rest before one asteroid, with or without hazards, fields and other asteroids beside the line. */
function onLine(d: Dice): Level {
  const range = d.pick(60, 120, 250, 250, 250, 1000, 5000, 2e4, 3e5);
  const centre = d.pick(d.between(20, 200), d.between(0.2, 0.98) * range, 0.999 * range, 12.5);
  const recoil = d.chance(0.3);
  const target = rock(
    Math.min(centre, 0.999 * range),
    0,
    recoil ? d.pick(0.01, 0.5, 4, 16, 64) : d.pick(1, 16, 32),
    d.chance(0.15),
  );
  const novae = [
    ...(d.chance(0.4) ? [circle(target.x + d.between(30, 200), d.between(-12, 12), d.pick(5, 16, 32))] : []),
    ...(d.chance(0.4) ? [circle(-d.between(20, 150), d.between(-12, 12), d.pick(5, 16, 32))] : []),
    ...(d.chance(0.25) ? [circle(d.between(0.3, 0.8) * target.x, d.between(-20, 20), d.pick(5, 16))] : []),
  ];
  const side = d.chance(0.5) ? 1 : -1;
  // With recoil, also about where the range ends.
  const beside = () => target.x + (recoil ? d.between(-1.2, 1.2) * range : d.between(-50, 300));
  const others = d.chance(0.3) ? [rock(beside(), side * d.between(60, 600), 16)] : [];
  const repulsors = d.chance(0.2) ? [circle(d.between(-100, 300), d.between(33, 200), 32)] : [];
  return {
    ...EMPTY,
    range,
    recoil,
    asteroids: [target, ...others],
    novae: novae.filter((n) => Math.hypot(n.x, n.y) > n.radius + 19),
    repulsors,
  };
}

/** A start with a velocity, towards hazards or the end of the range. */
function moving(d: Dice, finely: boolean): Level {
  const speed = d.pick(20, 60, 60, 120, 300);
  const ahead = d.between(0.5, 1.2) * speed;
  const wall = d.chance(0.6);
  const size = d.pick(16, 32);
  const reach = finely ? 60 : 160;
  const novae = wall
    ? Array.from({ length: d.upTo(5) + 2 }, (_, i, { length = d.upTo(5) + 2 } = { length: 5 }) =>
        circle(ahead + size + 20, (i - length / 2) * (2 * size + d.between(0, 15)), size),
      )
    : [];
  const range = wall ? 250 : d.pick(60, 100, 150);
  const rocks = [
    rock(d.pick(-0.8, -0.5, 0.3, 0.8) * range, d.between(-0.5, 0.5) * range, 16, d.chance(0.2)),
    ...(d.chance(0.4) ? [rock(d.between(-reach, reach), d.between(-reach, reach), 16)] : []),
  ];
  const aliens = finely
    ? Array.from({ length: d.pick(0, 1, 2, 3, 5) }, () => circle(ahead + d.between(0, 60), d.between(-50, 50), d.pick(6, 12, 25)))
    : [];
  const repulsors = d.chance(0.2) ? [circle(d.between(0, ahead), d.between(-60, 60), d.pick(32, 48))] : [];
  const apart = (c: Circle) => Math.hypot(c.x, c.y) > c.radius + 20;
  return {
    ...EMPTY,
    range,
    recoil: d.chance(0.3),
    astronaut: { x: 0, y: 0, vx: speed, vy: 0 },
    asteroids: rocks,
    novae: novae.filter(apart),
    aliens: aliens.filter(apart),
    repulsors,
  };
}

/**
 * Around an asteroid that a run soon ends at: it is hot, or its range is short, or novae stand around it. She starts at its very
 * centre, at the end of its range, or anywhere else; others lie beside it, in the same place, or as near to her.
 */
function orbiting(d: Dice): Level {
  const range = d.pick(40, 60, 80, 100, 150, 250, 2000);
  const ends = d.pick('hot', 'range', 'ring', 'ring');
  const reach = Math.min(range, ends === 'range' ? range : 120);
  const far = d.pick(0, 1e-9, 0.3 * reach, d.between(0.1, 0.98) * reach, 0.999 * reach, ends === 'range' ? range : 20);
  const speed = d.pick(15, 40, 60, 90, 150, 300, 480);
  const turn = d.pick(0, 0, Math.PI, Math.PI / 2, d.between(0, 6.3));
  const recoil = d.chance(0.3);
  const size = () => (recoil ? d.pick(0.02, 0.5, 4, 16, 32) : d.pick(1, 16, 32));
  const first = { ...rock(far, 0, size()), hot: ends === 'hot' };
  const beside = d.pick(0, 1, d.between(5, 60), d.between(50, 250));
  const side = d.between(0, 6.3);
  const others = [
    ...(d.chance(0.4) ? [rock(far + beside * Math.cos(side), beside * Math.sin(side), size(), d.chance(0.3))] : []),
    // as near to the start as the first
    ...(d.chance(0.15) ? [rock(far * Math.cos(side), far * Math.sin(side), size())] : []),
  ];
  const ring = d.between(45, 110);
  const count = Math.ceil((2 * Math.PI * ring) / d.between(35, 75));
  const novae = Array.from({ length: ends === 'ring' || d.chance(0.2) ? count : 0 }, (_, n) =>
    circle(far + ring * Math.cos((6.2832 * n) / count), ring * Math.sin((6.2832 * n) / count), d.pick(16, 25, 32)),
  );
  const repulsors = d.chance(0.15) ? [circle(far + d.between(-80, 80), d.between(-80, 80), d.pick(32, 48))] : [];
  return {
    ...EMPTY,
    range,
    recoil,
    astronaut: { x: 0, y: 0, vx: speed * Math.cos(turn), vy: speed * Math.sin(turn) },
    asteroids: [ends === 'hot' && far < first.radius + 20 ? { ...first, hot: false } : first, ...others],
    novae: novae.filter((c) => Math.hypot(c.x, c.y) > c.radius + 20),
    repulsors,
  };
}

/** Too fast to stop before a wall, so that the run ends soon. */
function wall(d: Dice): Level {
  const speed = d.between(55, 110);
  const far = d.between(0.8, 1.1) * speed;
  const apart = d.between(50, 66);
  const novae = [-1, 0, 1].map((n) => circle(far, n * apart + d.between(-3, 3), 32));
  return {
    ...EMPTY,
    recoil: d.chance(0.3),
    astronaut: { x: 0, y: 0, vx: speed, vy: 0 },
    asteroids: [rock(-d.between(60, 200), d.between(-60, 60), 16, d.chance(0.2))],
    novae,
    repulsors: d.chance(0.15) ? [circle(far / 2, d.between(30, 80), 32)] : [],
  };
}

/** The level rotated about the start: often not at all, or by quarter turns, for lines along an axis. */
function turned(level: Level, d: Dice): Level {
  const [cos, sin] = d.chance(0.3) ? d.pick([1, 0], [0, 1], [-1, 0], [0, -1]) : unit(d.between(-1, 1), d.between(-1, 1));
  const turn = <T extends { x: number; y: number }>(c: T): T => ({ ...c, x: c.x * cos - c.y * sin, y: c.x * sin + c.y * cos });
  const { vx, vy } = level.astronaut;
  const v = turn({ x: vx, y: vy });
  return everywhere({ ...level, astronaut: { x: 0, y: 0, vx: v.x, vy: v.y } }, turn);
}

const moved = (level: Level, x: number, y: number): Level => {
  const all = everywhere(level, (c) => ({ ...c, x: c.x + x, y: c.y + y }));
  return { ...all, astronaut: { ...level.astronaut, x, y } };
};

function everywhere(level: Level, change: <T extends { x: number; y: number }>(c: T) => T): Level {
  return {
    ...level,
    asteroids: level.asteroids.map(change),
    novae: level.novae.map(change),
    repulsors: level.repulsors.map(change),
    aliens: level.aliens.map(change),
  };
}

function unit(x: number, y: number): [number, number] {
  const length = Math.hypot(x, y) || 1;
  return [x / length, y / length];
}
