import type { OpenLevel } from '../context/index.ts';
import { endInWords, isWhole } from '../proof/index.ts';
import type { SessionStore } from '../session/index.ts';
import type { SettingsStore } from '../settings/index.ts';
import { jobs, type Leeway, type Results, type Running, type Workers } from '../workers/index.ts';
import { leewayOf } from './leeway-store.ts';
import { asksSame, contains, isOnlyMoved, objectsAsked, type Question, questionOf, type Seen } from './question.ts';

/** Shows or hides where the selection may stand. */
export const LEEWAY_KEY = 'Shift+l';

/** ms without a change before anything is sampled */
const SETTLE = 120;

interface LeewayParts {
  readonly level: Pick<OpenLevel, 'document' | 'proof' | 'selection'>;
  readonly session: SessionStore;
  readonly settings: Pick<SettingsStore, 'getState' | 'subscribe'>;
  readonly workers: Pick<Workers, 'start'>;
  /** What the canvas shows, px of the level. */
  readonly seen: { now(): Seen; subscribe(call: () => void): () => void };
  /** Calls back once the page has been at rest for `ms`. @returns cancels it */
  readonly afterRest: (ms: number, call: () => void) => () => void;
}

/**
 * While the layer is shown, samples where the selection may stand. What was found stays for as long as it is true: also while the
 * selection is dragged, as everything else is unchanged.
 */
export function watchLeeway({ level, session, settings, workers, seen, afterRest }: LeewayParts): () => void {
  const { document, proof, selection } = level;
  const store = leewayOf(level);
  let job: Running<Results['leeway']> | null = null;
  /** What is being sampled, or was. */
  let asked: Question | null = null;
  /** What was found while something is dragged: drawing it would delay the drag. */
  let held: Leeway | null = null;
  let forget = () => {};

  const isOn = () => session.getState().layers.leeway && session.getState().mode === 'edit';
  const isInHand = () => document.settledFile() !== document.file();
  const grid = () => {
    const { snapToGrid, grid: size } = settings.getState();
    return snapToGrid ? size : null;
  };
  const question = () =>
    questionOf(proof.proof(), selection.keys(), { only: store.getState().only, grid: grid(), seen: seen.now() });
  const stop = () => {
    forget();
    job?.cancel();
    job = null;
    asked = null;
    held = null;
  };
  const put = (leeway: Leeway) => {
    if (asked === null) return;
    if (isInHand()) held = leeway;
    else {
      held = null;
      const isTooLarge = leeway.base === 'unknown';
      store.setState({
        phase: isTooLarge ? 'too large' : leeway.isFinished ? 'done' : 'sampling',
        message: null,
        answer: isTooLarge ? null : { question: asked, leeway },
      });
    }
  };
  const begin = () => {
    const now = question();
    if (now === null || !isWhole(proof.proof())) return;
    job?.cancel();
    asked = now;
    held = null;
    const { level: played, terms, holds, only, lead, grid: size, seen: region } = now;
    const objects = objectsAsked(now).map(({ kind, index }) => ({ kind, index }));
    const mine = workers.start(
      jobs.leeway,
      { level: { ...played, runs: [] }, terms, holds, objects, only, lead, grid: size, seen: region },
      (leeway) => {
        if (job === mine) put(leeway);
      },
    );
    job = mine;
    void mine.end.then((end) => {
      if (job !== mine) return;
      if (end.kind === 'done') put(end.result);
      else if (end.kind !== 'cancelled') store.setState({ phase: 'failed', message: end.message, answer: null });
    });
  };
  /** @returns whether what is known is still true */
  const isTrue = (known: Question, now: Question): boolean => asksSame(known, now) && isOnlyMoved(known, now);

  const look = () => {
    if (!isOn()) {
      stop();
      if (store.getState().phase !== 'off') store.setState({ phase: 'off', message: null, answer: null });
      return;
    }
    const now = question();
    if (now === null) {
      stop();
      if (store.getState().phase !== 'nothing selected')
        store.setState({ phase: 'nothing selected', message: null, answer: null });
      return;
    }
    const known = store.getState().answer?.question ?? null;
    if (isInHand()) {
      // holds may be re-timed in the same gesture: the answer is about those when it began
      const start = asked ?? known;
      if (start !== null && isOnlyMoved(start, proof.proof())) return;
      stop();
      store.setState({ phase: 'waiting', message: null, answer: null });
      return;
    }
    if (asked !== null && asked.file === now.file && asksSame(asked, now) && contains(asked.seen, now.seen)) {
      if (held !== null) put(held);
      return;
    }
    stop();
    if (!isWhole(proof.proof())) {
      store.setState({ phase: 'too large', message: endInWords(proof.proof()), answer: null });
      return;
    }
    // what was found is shown until something newer is known
    store.setState({ phase: 'waiting', message: null, ...(known !== null && isTrue(known, now) ? {} : { answer: null }) });
    forget = afterRest(SETTLE, begin);
  };
  look();
  let wasOn = isOn();
  let { only } = store.getState();
  const stops = [
    proof.store.subscribe(look),
    document.onStep(look),
    selection.store.subscribe(look),
    settings.subscribe(look),
    seen.subscribe(look),
    session.subscribe(() => {
      if (isOn() === wasOn) return;
      wasOn = isOn();
      look();
    }),
    store.subscribe((now) => {
      if (now.only === only) return;
      only = now.only;
      look();
    }),
  ];
  return () => {
    for (const end of stops) end();
    stop();
    store.setState({ phase: 'off', message: null, answer: null });
  };
}
