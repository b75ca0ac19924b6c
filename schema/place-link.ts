/** A place that a link to the editor's page names. */
export interface EditorPlace {
  /** The level: its id, its file or its name. */
  readonly level: string;
  /** The name of the run to show; null: the first. */
  readonly run: string | null;
  /** The tick of 1/60 s to show; null: the first. */
  readonly tick: number | null;
}

/** What a fragment of the page's address says about a place. */
export interface PlaceReading {
  /** The place; without a tick where that could not be read. */
  readonly place: EditorPlace;
  /** Why the tick could not be read, for people; null if it could, or if none is given. */
  readonly problem: string | null;
}

/** A level inside a link (see `editor/features/share`) is longer than any name of a file. */
const LONGEST_NAME = 80;
const TICK = /^\d{1,9}$/;

/** Half a pair of UTF-16, which no address can have, becomes the sign for what is damaged. */
const encoded = (text: string): string => encodeURIComponent(text.replace(/\p{Surrogate}/gu, '\u{fffd}')).replaceAll('%2F', '/');

function decoded(text: string): string {
  try {
    return decodeURIComponent(text);
  } catch {
    // a % that begins no escape
    return text;
  }
}

/**
 * The fragment of a link to a place, without `#`: `level=levels/07.level.json&tick=412&run=solution`.
 *
 * @param place - the place
 * @returns the fragment
 */
export function placeFragment(place: EditorPlace): string {
  const { level, run, tick } = place;
  const parts = [`level=${encoded(level)}`];
  if (tick !== null) parts.push(`tick=${tick}`);
  if (run !== null) parts.push(`run=${encoded(run)}`);
  return parts.join('&');
}

/**
 * The place that the fragment of an address names; null if it names none. A level inside a link has the same key `level`: it is
 * told apart by its length, and comes without a run and a tick.
 *
 * @param fragment - the fragment, with or without `#`
 * @returns the place, and what is wrong with it
 */
export function placeIn(fragment: string): PlaceReading | null {
  const parts = fragment.replace(/^#/, '').split('&');
  const given = (key: string): string | null => {
    const part = parts.find((one) => one.startsWith(`${key}=`))?.slice(key.length + 1) ?? '';
    return part === '' ? null : part;
  };
  const [level, run, tick] = [given('level'), given('run'), given('tick')];
  if (level === null) return null;
  if (run === null && tick === null && level.length > LONGEST_NAME && /^[\w-]+$/.test(level)) return null;
  const isTick = tick === null || TICK.test(tick);
  return {
    place: {
      level: decoded(level),
      run: run === null ? null : decoded(run),
      tick: isTick && tick !== null ? Number(tick) : null,
    },
    problem: isTick ? null : `expected a tick like 412, found ${JSON.stringify(decoded(tick).slice(0, LONGEST_NAME))}`,
  };
}
