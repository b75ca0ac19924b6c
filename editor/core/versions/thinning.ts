import { shortened, type Version } from './version.ts';

const MINUTE = 60_000;
const HOUR = 60 * MINUTE;
const DAY = 24 * HOUR;

/** How far apart versions are kept: those older than `age` have at most one per `apart`, ms. */
export const STAGES = [
  { age: 30 * DAY, apart: DAY },
  { age: DAY, apart: HOUR },
  { age: HOUR, apart: MINUTE },
] as const;

/** The most versions without a name that a history keeps. */
export const MOST_VERSIONS = 3000;
/** The most characters that are stored for the versions of a history that have no name. */
export const MOST_SIZE = 16_000_000;

/** What becomes of a history. */
export interface Thinning {
  readonly drop: readonly number[];
  /** Versions that take over the labels of those that were dropped before them. */
  readonly put: readonly Version[];
}

/** The limits of a history. */
export interface ThinningLimits {
  readonly versions: number;
  readonly size: number;
}

/**
 * Which versions are dropped as they age: of those without a name, the last one of each minute, hour or day stays. The last
 * version always stays, and so does every one with a name. The labels of dropped versions go to the next one that stays.
 * @param versions oldest first
 * @param now ms since 1970
 */
export function thin(
  versions: readonly Version[],
  now: number,
  limits: ThinningLimits = { versions: MOST_VERSIONS, size: MOST_SIZE },
): Thinning {
  const drop = new Set<number>();
  const seen = new Set<string>();
  const unnamed = versions.slice(0, -1).filter(({ name }) => name === null);
  let [count, size] = [0, 0];
  // the newest first: the last version of each stretch of time is met first
  for (const { number, time, size: own } of unnamed.reverse()) {
    const stage = STAGES.find(({ age }) => now - time > age);
    const stretch = stage === undefined ? null : `${stage.apart} ${Math.floor(time / stage.apart)}`;
    const isLater = stretch !== null && seen.has(stretch);
    if (stretch !== null) seen.add(stretch);
    if (isLater || count >= limits.versions || size + own > limits.size) drop.add(number);
    else {
      count++;
      size += own;
    }
  }
  return { drop: [...drop], put: labelsPassedOn(versions, drop) };
}

/** The versions that stay, with the labels of those that are dropped before them; only those that change. */
function labelsPassedOn(versions: readonly Version[], drop: ReadonlySet<number>): Version[] {
  const put: Version[] = [];
  let labels: readonly string[] = [];
  let more = 0;
  let isDropped = false;
  for (const version of versions) {
    if (drop.has(version.number)) {
      labels = [...labels, ...version.labels];
      more += version.more;
      isDropped = true;
      continue;
    }
    // what it changed is told of a version that is gone
    if (isDropped) put.push({ ...version, ...shortened([...labels, ...version.labels], more + version.more), changes: '' });
    [labels, more, isDropped] = [[], 0, false];
  }
  return put;
}
