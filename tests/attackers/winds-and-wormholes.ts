import type { Level } from '../../schema/index.ts';

/** The level with one or two winds, a wormhole, or both: near her path, or so far away that a proof may leave them out. */
export function withWindsAndWormholes(level: Level, random: () => number): Level {
  const pick = <T>(...of: T[]): T => of[Math.floor(random() * of.length)];
  const place = () => {
    const turn = 6.2832 * random();
    const far = pick(0, 60, 150, 400, 400, 900) * (0.7 + 0.6 * random());
    return { x: level.astronaut.x + far * Math.cos(turn), y: level.astronaut.y + far * Math.sin(turn) };
  };
  const strength = () => pick(0, 100, -100, 60 * (random() - 0.5));
  const winds: Level['winds'] = Array.from({ length: Math.floor(random() * 3) }, () => ({
    id: null,
    ...place(),
    radius: pick(10, 40, 120),
    ax: strength(),
    ay: strength(),
  }));
  const wormholes: Level['wormholes'] = Array.from({ length: random() < 0.6 ? 1 : 0 }, () => {
    const { x: toX, y: toY } = place();
    return { id: null, ...place(), toX, toY, radius: pick(5, 20, 50) };
  });
  return { ...level, winds, wormholes };
}
