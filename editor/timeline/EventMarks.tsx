import { memo } from 'react';
import { effectEventInWords, type RunEvent } from '../../engine/index.ts';
import { type Scale, toX } from './scale.ts';

interface EventMarksProps {
  readonly events: readonly RunEvent[];
  readonly scale: Scale;
  readonly width: number;
}

/** A short text for the lane and a longer one for the tooltip; null for events that the lane itself shows. */
function wordsOf(event: RunEvent): readonly [short: string, long: string] | null {
  switch (event.type) {
    case 'press':
    case 'release':
      return null;
    case 'target':
      return [`A${event.index + 1}`, `asteroid ${event.index + 1} becomes the target`];
    case 'mineral':
      return [`◆${event.index + 1}`, `mineral ${event.index + 1} is collected`];
    case 'enter':
      return [`R${event.index + 1}`, `enters repulsor ${event.index + 1}`];
    case 'leave':
      return [`/R${event.index + 1}`, `leaves repulsor ${event.index + 1}`];
    case 'effect':
      return ['~', effectEventInWords(event)];
    case 'wake':
      return [`E${event.index + 1}!`, `alien ${event.index + 1} wakes up`];
    case 'sleep':
      return [`E${event.index + 1}z`, `alien ${event.index + 1} falls asleep`];
    case 'explosion':
      return ['✺', `aliens ${event.aliens[0] + 1} and ${event.aliens[1] + 1} explode`];
    case 'completed':
      return ['●', 'reaches the black hole'];
    case 'collided':
      return ['✕', 'collides'];
    case 'lost':
      return ['✕', 'is lost'];
  }
}

/** px that a mark needs, so that two don't overlap */
const ROOM = 22;

/** The events of the run as short marks; their tooltips say more. */
export const EventMarks = memo(function EventMarks({ events, scale, width }: EventMarksProps) {
  let free = Number.NEGATIVE_INFINITY;
  const marks = events.flatMap((event) => {
    const words = wordsOf(event);
    const x = toX(scale, event.time * 60);
    if (words === null || x < 0 || x > width || x < free) return [];
    free = x + ROOM;
    return [{ key: `${event.type} ${event.time}`, x, short: words[0], long: `${event.time.toFixed(2)} s: ${words[1]}` }];
  });
  return (
    <ol className="marks" aria-label="Events of the run">
      {marks.map(({ key, x, short, long }) => (
        <li key={key} className="marks__mark" style={{ left: x }} title={long}>
          <span aria-hidden>{short}</span>
          <span className="unseen">{long}</span>
        </li>
      ))}
    </ol>
  );
});
