import { type Hold, LIMITS, type RunNote } from '../basics/index.ts';
import type { RunTextReading, RunTextRemark } from './run-text.ts';
import { LINE_BREAK, notesInOrder } from './shape.ts';
import { TextWalk } from './text-walk.ts';

/** Options of {@link readRunText}. */
export interface ReadRunTextOptions {
  /**
   * Whether the text stands on a command line, where what looks like a slip is refused: holds that overlap or are out of order, a
   * comma that is missing or too many, and no holds without the word `none`.
   */
  readonly isStrict?: boolean;
}

const BLANK = /[^\S\n\r\v\f\u2028\u2029]+/y;
const BREAK = new RegExp(LINE_BREAK.source, 'y');
const NUMBER = /\d+(?:\.\d+)?/y;
const SECONDS = /[^\S\n\r\v\f\u2028\u2029]*[sS](?![\p{L}\p{N}])/uy;
const DASH = /-|–|—|−|\.\.\.?|…/y;
const NONE = /none(?![\p{L}\p{N}])/iuy;
const REST = /[^\n\r\v\f\u0085\u2028\u2029]*/y;

/** Digits of a number that are shown. */
const MOST_DIGITS = 20;
const RATE = 60;

/** A tick as it was written. */
interface Time {
  readonly tick: number;
  readonly text: string;
  readonly at: number;
  readonly inSeconds: boolean;
}

/** Reads one text. */
class Reader {
  private readonly walk: TextWalk;
  private readonly holds: Hold[] = [];
  private readonly places: number[] = [];
  private readonly notes: RunNote[] = [];
  private readonly rounded: { at: number; message: string }[] = [];
  /** Whether a hold stands on the current line, and a comma must come before the next. */
  private needsComma = false;
  /** Whether `none` was read. */
  private isNone = false;

  constructor(
    text: string,
    private readonly isStrict: boolean,
  ) {
    this.walk = new TextWalk(text);
  }

  read(): RunTextReading {
    const { walk } = this;
    /** The tick of a note on this line; null: that of its last hold, or of the line before. */
    let noted: number | null = null;
    let comma = false;
    for (;;) {
      walk.take(BLANK);
      if (walk.isAtEnd) break;
      if (walk.take(BREAK) !== null) {
        noted = null;
        this.needsComma = false;
        comma = false;
      } else if (walk.take('#') !== null) {
        this.comment(noted ?? this.holds.at(-1)?.[1] ?? 0);
      } else if (walk.next === ',' && this.needsComma) {
        walk.take(',');
        this.needsComma = false;
        comma = true;
      } else if (walk.take('@') !== null) {
        noted = this.time('the tick of a note').tick;
        walk.take(BLANK);
        if (walk.next !== '#') walk.fail(`expected # and the text of the note after @${noted}`, 'Write @200 # text.');
      } else if (this.holds.length === 0 && !this.isNone && walk.take(NONE) !== null) {
        this.isNone = true;
      } else {
        this.hold();
        noted = this.holds[this.holds.length - 1][0];
        comma = false;
      }
    }
    if (this.isStrict && ((this.holds.length === 0 && !this.isNone) || comma)) this.time('the tick of a press');
    return { ok: true, holds: this.holds, notes: notesInOrder(this.notes), remarks: this.remarks() };
  }

  private hold(): void {
    const { walk, holds } = this;
    if (this.isNone) walk.fail('expected nothing after none', 'Remove none, or the holds.');
    if (this.isStrict && this.needsComma) walk.fail('expected "," and another hold, or the end', 'Write 12-96,130-188.');
    const press = this.time('the tick of a press');
    walk.take(BLANK);
    if (walk.take(DASH) === null) {
      walk.fail(`expected "-" and the tick of the release after ${press.text}`, `Write ${press.text}-RELEASE.`);
    }
    walk.take(BLANK);
    const release = this.time('the tick of a release');
    if (press.inSeconds !== release.inSeconds) {
      const both = press.inSeconds ? [press.text, `${release.text}s`] : [`${press.text}s`, release.text];
      walk.failAt(
        press.at,
        `expected both in ticks or both in seconds, found ${press.text} and ${release.text}`,
        `Write ${both.join('-')}, or both without s.`,
      );
    }
    if (release.tick <= press.tick) {
      walk.failAt(
        press.at,
        `the release (${release.text}) must be later than the press (${press.text})`,
        release.tick < press.tick ? `Write ${release.text}-${press.text}.` : 'Release a tick later, or remove the hold.',
      );
    }
    const last = holds.at(-1);
    if (this.isStrict && last !== undefined && press.tick < last[1]) {
      walk.failAt(
        press.at,
        `this hold begins at ${press.text}, before the previous one ends (${last[1]})`,
        'Write holds in order of time.',
      );
    }
    if (holds.length === LIMITS.holds) {
      walk.failAt(press.at, `expected at most ${LIMITS.holds} holds, found another`, 'Remove some of them.');
    }
    holds.push([press.tick, release.tick]);
    this.places.push(press.at);
    this.needsComma = true;
    // what stands right behind a hold belongs to it
    walk.take(BLANK);
    const { isAtEnd, next } = walk;
    if (isAtEnd || next === ',' || next === '#' || next === '@' || walk.sees(BREAK) || walk.sees(NUMBER)) return;
    walk.fail('expected "," and another hold, or the end', 'Separate holds by commas: 12-96, 130-188.');
  }

  private time(what: string): Time {
    const { walk } = this;
    const { at } = walk;
    const digits = walk.take(NUMBER);
    if (digits === null) {
      walk.fail(
        `expected ${what} here (a whole number from 0 to ${LIMITS.tick})`,
        'Write a hold as PRESS-RELEASE in ticks of 1/60 s, like 12-96, or in seconds, like 0.2s-1.6s.',
      );
    }
    const written = digits as string;
    const shown = written.length > MOST_DIGITS ? `${written.slice(0, MOST_DIGITS)}…` : written;
    const inSeconds = walk.take(SECONDS) !== null;
    if (!inSeconds && written.includes('.')) {
      walk.failAt(at, `expected "-" or a whole number of ticks, found ${shown}`, `For seconds, write ${shown}s.`);
    }
    const exact = inSeconds ? Number(written) * RATE : Number(written);
    if (exact > LIMITS.tick) {
      const most = inSeconds ? `${LIMITS.tick / RATE}s` : String(LIMITS.tick);
      walk.failAt(at, `tick ${shown}${inSeconds ? 's' : ''} is later than ${most}, which is an hour`, 'Write an earlier one.');
    }
    const tick = Math.round(exact);
    // 0.1 s is 6 ticks, though not to the last bit
    if (Math.abs(exact - tick) > 1e-6) this.rounded.push({ at, message: `${shown}s is rounded to tick ${tick}` });
    return { tick, text: inSeconds ? `${shown}s` : String(tick), at, inSeconds };
  }

  private comment(tick: number): void {
    const { walk } = this;
    const { at } = walk;
    const text = (walk.take(REST) ?? '').trim();
    if (text === '') return;
    if (text.length > LIMITS.note) {
      const message = `expected a note of at most ${LIMITS.note} characters, found ${text.length}`;
      walk.failAt(at - 1, message, 'Shorten it, or split it into two notes.');
    }
    if (this.notes.length === LIMITS.notes) {
      walk.failAt(at - 1, `expected at most ${LIMITS.notes} notes, found another`, 'Remove some of them.');
    }
    this.notes.push({ tick, text });
  }

  private remarks(): RunTextRemark[] {
    const all = [...this.rounded, ...joinedInWords(this.holds, this.places)].sort((a, b) => a.at - b.at);
    const placed = this.walk.places(all.map(({ at }) => at));
    return all.map(({ message }, i) => ({ ...placed[i], message }));
  }
}

/**
 * Reads a run as text: holds as `PRESS-RELEASE` in ticks of 1/60 s, or in seconds with an `s`, separated by commas or lines;
 * `..` does for `-`. What stands behind `#` is a note: at the press of the last hold on its line; on a line without holds at the
 * release of the hold before, at tick 0 if there is none, or at the tick that the line says, as in `@300 # text`. Never throws.
 *
 * @param text - any text
 * @param options - how strict to be
 * @returns holds in the order of the text, which may overlap and be out of order, and notes sorted by tick; or the first mistake
 */
export function readRunText(text: string, { isStrict = false }: ReadRunTextOptions = {}): RunTextReading {
  return TextWalk.catching(() => new Reader(text, isStrict).read());
}

/** Something to say of a place in the text. */
interface Said {
  readonly at: number;
  readonly message: string;
}

/**
 * What becomes of holds that overlap, touch or are out of order.
 * @param places the offset of each hold in its text
 */
function joinedInWords(holds: readonly Hold[], places: readonly number[]): Said[] {
  const said: Said[] = [];
  const late = holds.findIndex(([press], i) => i > 0 && press < holds[i - 1][0]);
  if (late >= 0) said.push({ at: places[late], message: 'the holds are put in order of time' });
  const sorted = [...holds.keys()].sort((a, b) => holds[a][0] - holds[b][0]);
  for (let i = 0; i < sorted.length; ) {
    const group = [sorted[i]];
    const [press] = holds[sorted[i]];
    let [, release] = holds[sorted[i]];
    for (i++; i < sorted.length && holds[sorted[i]][0] <= release; i++) {
      group.push(sorted[i]);
      release = Math.max(release, holds[sorted[i]][1]);
    }
    if (group.length === 1) continue;
    const what = group.length === 2 ? group.map((k) => holds[k].join('-')).join(' and ') : `${group.length} holds`;
    said.push({
      at: Math.max(...group.map((k) => places[k])),
      message: `${what} overlap or touch, and become ${press}-${release}`,
    });
  }
  return said;
}
