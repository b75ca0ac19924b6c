import { createStore } from 'zustand/vanilla';
import { type Desk, question } from '../../core/ask/index.ts';
import type { OpenLevel } from '../../core/context/index.ts';
import { ofDocument } from '../../core/kept/index.ts';
import { endInWords, isWhole, withoutRuns } from '../../core/proof/index.ts';
import type { SessionStore } from '../../core/session/index.ts';
import type { SettingsStore } from '../../core/settings/index.ts';
import { jobs, type Leeway } from '../../workers/index.ts';
import { asksSame, contains, isOnlyMoved, objectsAsked, type Question, questionOf, type Seen } from './question.ts';

/** Shows or hides where the selection may stand. */
export const LEEWAY_KEY = 'Shift+l';

interface LeewayParts {
  readonly level: Pick<OpenLevel, 'document' | 'proof' | 'selection'>;
  readonly session: SessionStore;
  readonly settings: Pick<SettingsStore, 'getState' | 'subscribe'>;
  /** What the canvas shows, px of the level. */
  readonly seen: { now(): Seen; subscribe(call: () => void): () => void };
}

const isOn = ({ session }: LeewayParts) => session.getState().layers.leeway && session.getState().mode === 'edit';
const isInHand = ({ level: { document } }: LeewayParts) => document.committedFile() !== document.file();

/** What is asked at the moment; null: nothing is selected. */
function questionNow({ level, settings, seen }: LeewayParts): Question | null {
  const { snapToGrid, grid } = settings.getState();
  const { only } = leewayOf(level).getState();
  return questionOf(level.proof.proof(), level.selection.keys(), { only, grid: snapToGrid ? grid : null, seen: seen.now() });
}

/** What the question and its answer depend on. */
const leewayLooks = (parts: LeewayParts): ((look: () => void) => () => void)[] => [
  parts.level.proof.store.subscribe,
  parts.level.document.onStep,
  parts.level.selection.store.subscribe,
  parts.settings.subscribe,
  parts.seen.subscribe,
  (look) => {
    let wasOn = isOn(parts);
    return parts.session.subscribe(() => {
      if (isOn(parts) === wasOn) return;
      wasOn = isOn(parts);
      look();
    });
  },
  (look) => leewayOf(parts.level).subscribe((now, before) => now.only !== before.only && look()),
];

/** Where the selection may stand. */
export const leewayQuestion = question({
  job: jobs.leeway,
  request(of: Question) {
    const { level, terms, holds, only, lead, grid, seen } = of;
    const objects = objectsAsked(of).map(({ kind, index }) => ({ kind, index }));
    return { level: withoutRuns(level), terms, holds, objects, only, lead, grid, seen };
  },
  follows: {
    wait: { rest: 120 },
    of(parts: LeewayParts, asked) {
      const { proof } = parts.level;
      if (!isOn(parts)) return null;
      // holds may be re-timed in the same gesture: the answer is about those when it began
      if (isInHand(parts)) return asked !== null && isOnlyMoved(asked, proof.proof()) ? asked : null;
      return isWhole(proof.proof()) ? questionNow(parts) : null;
    },
    same: (asked, now) => asked.file === now.file && asksSame(asked, now) && contains(asked.seen, now.seen),
    on: leewayLooks,
  },
});

/**
 * While the layer is shown, samples where the selection may stand. What was found stays for as long as it is true: also while the
 * selection is dragged, as everything else is unchanged.
 */
export function watchLeeway({ desk, ...parts }: LeewayParts & { readonly desk: Desk }): () => void {
  const { proof } = parts.level;
  const store = leewayOf(parts.level);
  const leeway = leewayQuestion(desk, parts);
  const put = (now: Partial<LeewayFindings>) => store.setState({ message: null, answer: null, ...now });

  const show = () => {
    if (!isOn(parts)) {
      if (store.getState().phase !== 'off') put({ phase: 'off' });
      return;
    }
    const now = questionNow(parts);
    if (now === null) {
      if (store.getState().phase !== 'nothing selected') put({ phase: 'nothing selected' });
      return;
    }
    const { phase, of, progress, answer, message } = leeway.store.getState();
    if (isInHand(parts)) {
      // drawing what is found while something is dragged would delay the drag
      if (phase === 'idle') put({ phase: 'waiting' });
      return;
    }
    const found = answer ?? progress;
    const known = store.getState().answer;
    // what was found is shown until something newer is known
    const isTrue = known !== null && asksSame(known.question, now) && isOnlyMoved(known.question, now);
    if (!isWhole(proof.proof())) put({ phase: 'too large', message: endInWords(proof.proof()) });
    else if (phase === 'failed') put({ phase, message });
    else if (of === null || found === null) put({ phase: 'waiting', answer: isTrue ? known : null });
    else if (found.base === 'unknown') put({ phase: 'too large' });
    else put({ phase: found.isFinished ? 'done' : 'sampling', answer: { question: of, leeway: found } });
  };
  show();
  const stops = [...leewayLooks(parts).map((subscribe) => subscribe(show)), leeway.store.subscribe(show)];
  return () => {
    for (const end of stops) end();
    leeway.close();
    put({ phase: 'off' });
  };
}

/** What is known of where the selection may stand. */
export interface LeewayFindings {
  /**
   * `off`: it is not shown. `nothing selected`: it is, but nothing is asked. `waiting`: the level has just changed. `too large`:
   * the level takes too much work. `done`: nothing finer is sampled.
   */
  readonly phase: 'off' | 'nothing selected' | 'waiting' | 'sampling' | 'done' | 'too large' | 'failed';
  /** Why it failed, or why the level is not simulated; null: neither. */
  readonly message: string | null;
  /** What was asked, and what is known; null: nothing is. */
  readonly answer: { readonly question: Question; readonly leeway: Leeway } | null;
  /** The place of an object with several that is moved alone; null: all of them. */
  readonly only: number | null;
}

/** What is known of where the selection of a level may stand. */
export const leewayOf = ofDocument(() =>
  createStore<LeewayFindings>(() => ({ phase: 'off', message: null, answer: null, only: null })),
);
