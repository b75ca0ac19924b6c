import { nameOf } from '../../core/document/index.ts';
import type { Leeway, Reach } from '../../workers/index.ts';
import { type LeewayFindings, objectsAsked, type Question } from './watch-leeway.ts';

const number = (px: number): string => String(Number(px.toFixed(2)));

/** The names of the places of an object that has several. */
export const PLACE_NAMES = ['first mouth', 'second mouth'] as const;

/** What is moved: `Asteroid 2`, the same with one of its places, or `3 objects, moved together`. */
export function movedInWords(question: Pick<Question, 'file' | 'keys' | 'only'>): string {
  const objects = objectsAsked(question);
  if (objects.length !== 1) return `${objects.length} objects, moved together`;
  const name = nameOf(objects[0]);
  const { only } = question;
  if (only === null) return name;
  const place = PLACE_NAMES[only] ?? `place ${only + 1}`;
  return `${place.charAt(0).toUpperCase()}${place.slice(1)} of ${name.toLowerCase()}`;
}

function freeInWords({ direction, same, isEnd }: Reach): string {
  if (!isEnd) return `${direction} ${same} px or more`;
  return same === 0 ? `${direction} not at all` : `${direction} ${same} px`;
}

function neededInWords({ direction, same, isEnd }: Reach): string {
  return isEnd ? `${direction} by ${same + 1} px` : `${direction} not within ${same} px`;
}

/** How far it may go in each direction, simulated px by px; null: not known yet. */
export function reachInWords({ base, reach, isReachKnown }: Pick<Leeway, 'base' | 'reach' | 'isReachKnown'>): string | null {
  if (base === null || base === 'unknown' || !isReachKnown) return null;
  return base === 'completes'
    ? `May go ${reach.map(freeInWords).join(', ')}.`
    : `Would complete ${reach.map(neededInWords).join(', ')}.`;
}

/** How finely it is sampled now. */
export function samplingInWords({ answer, phase }: Pick<LeewayFindings, 'answer' | 'phase'>): string {
  if (answer === null) return '';
  const { every, atEdges, isCovered, isFinished } = answer.leeway;
  const { grid } = answer.question;
  const coarsest = Math.max(every, atEdges);
  const isEveryPlace = grid !== null && isCovered && coarsest <= grid;
  const often = isEveryPlace ? `at every grid place (${number(grid)} px)` : `every ${number(coarsest)} px`;
  const edges = atEdges > 0 && atEdges < every ? `, at edges every ${number(atEdges)} px` : '';
  const rest = isCovered ? '' : '; dotted: not sampled yet';
  return `Sampled ${often}${edges}${rest}${phase !== 'done' && !isFinished ? '; refining…' : '.'}`;
}

/** What keeps it from being known, or what it is about; '' if nothing needs to be said. */
export function noteInWords({ phase, message, answer }: LeewayFindings): string {
  switch (phase) {
    case 'off':
      return '';
    case 'nothing selected':
      return 'Select an object to see where it may stand.';
    case 'too large':
      return `Not sampled: ${message ?? 'the run takes too much work'}.`;
    case 'waiting':
      return answer === null ? 'Waits until the level is at rest.' : '';
    case 'failed':
      return `Failed: ${message}. Hide and show it to try again.`;
    default:
      return answer === null ? 'Sampling where it may stand…' : '';
  }
}

/** What the shade means for this run. */
export function meaningInWords({ question, leeway }: NonNullable<LeewayFindings['answer']>): string {
  const run = question.run ?? 'the drift without a run';
  return leeway.base === 'fails'
    ? `Hatched: ${run} would complete the level. It fails as it is: there is no place to keep.`
    : `Hatched: ${run} still completes the level.`;
}
