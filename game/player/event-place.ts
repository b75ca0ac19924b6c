import type { RunEvent, Touched } from '../../engine/index.ts';
import type { Level } from '../../schema/basics/index.ts';
import type { Body } from './body.ts';

interface Place {
  readonly x: number;
  readonly y: number;
}

const her = ({ state }: Body): Place => ({ x: state[0], y: state[1] });

/** The point of the object that is nearest to her. */
function contact(level: Level, body: Body, { kind, index }: Touched): Place {
  if (kind === 'blackHole') return level.blackHole;
  const list = kind === 'nova' ? level.novae : kind === 'alien' ? level.aliens : level.asteroids;
  const { radius } = list[index];
  const isAlien = kind === 'alien';
  const x = isAlien ? body.alienX(index) : kind === 'nova' ? list[index].x : body.asteroidX(index);
  const y = isAlien ? body.alienY(index) : kind === 'nova' ? list[index].y : body.asteroidY(index);
  const [dx, dy] = [body.state[0] - x, body.state[1] - y];
  const part = radius / Math.max(radius, Math.sqrt(dx * dx + dy * dy));
  return { x: x + part * dx, y: y + part * dy };
}

/** Where a game shows an event. `body` is in the state after the tick of the event. */
export function eventPlace(level: Level, body: Body, event: RunEvent): Place {
  switch (event.type) {
    case 'mineral':
      return level.minerals[event.index];
    case 'target':
      return { x: body.asteroidX(event.index), y: body.asteroidY(event.index) };
    case 'wake':
    case 'sleep':
      return { x: body.alienX(event.index), y: body.alienY(event.index) };
    case 'explosion': {
      const [a, b] = event.aliens;
      return { x: (body.alienX(a) + body.alienX(b)) / 2, y: (body.alienY(a) + body.alienY(b)) / 2 };
    }
    case 'completed':
    case 'collided':
    case 'lost':
      return event.with === null ? her(body) : contact(level, body, event.with);
    default:
      return her(body);
  }
}
