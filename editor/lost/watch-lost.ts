import { type AccuracyName, joinHolds, type Scene, type Terms } from '../../engine/index.ts';
import type { Hold, Level } from '../../schema/index.ts';
import type { Attempt } from '../attempts/index.ts';
import type { OpenLevel } from '../context/index.ts';
import { isWhole } from '../proof/index.ts';
import type { SessionStore } from '../session/index.ts';
import { hashNow, shelfOf } from '../shelf/index.ts';
import { accuracyNameOf } from '../terms/index.ts';
import { jobs, type Losses, type Results, type Running, type Workers } from '../workers/index.ts';
import { lossKey, lostOf, NOTHING_LOST } from './lost-store.ts';

/** Shows or hides the shade. */
export const LOST_KEY = 'l';

/** Ticks for the states, as `gq check --softlocks` takes by default, and the factor of a search that goes on. */
export const EFFORT = 10_000_000;
const MORE = 4;

/** Ticks for the losses of all runs that are examined at once. */
const EFFORT_OF_RUNS = 20_000_000;

/** At most so many runs that fail are examined: the shown one, then the attempts, those that are selected first. */
const MOST_RUNS = 12;

/** ms without a change before anything is examined */
const SETTLE = 500;

/** The examination of where one level is already lost. */
export interface LostSession {
  /** Stops the examination and keeps what it has found. */
  stop(): void;
  /** Examines again, with several times the effort. */
  goOn(): void;
  close(): void;
}

interface LostParts {
  readonly level: Pick<OpenLevel, 'document' | 'proof' | 'attempts'>;
  readonly session: SessionStore;
  readonly workers: Pick<Workers, 'start'>;
  /** Calls back once the page has been at rest for `ms`. @returns cancels it */
  readonly afterRest: (ms: number, call: () => void) => () => void;
}

const completed = ({ end }: Attempt): boolean => end?.outcome === 'completed';

/**
 * While the layer is shown, examines where the level is already lost, and since when the shown run and attempts were lost. What
 * was found is thrown away when the level changes.
 */
export function watchLost({ level, session, workers, afterRest }: LostParts): LostSession {
  const { proof, attempts } = level;
  const store = lostOf(level);
  const shelf = shelfOf(level);
  let scene: Scene | null = null;
  let terms: Terms | null = null;
  let states: Running<Results['lost']> | null = null;
  let runs: Running<Results['losses']> | null = null;
  /** The runs that are being examined. */
  let asked = '';
  /** The runs of which nothing more is found. */
  const settled = new Set<string>();
  let forget = () => {};

  const drop = () => {
    forget();
    states?.cancel();
    runs?.cancel();
    states = null;
    runs = null;
    asked = '';
    settled.clear();
  };
  const isOurs = (accuracy: AccuracyName): boolean => accuracy === terms?.accuracy.name;
  /** The attempts at the level as it is now, the latest first. */
  const ownAttempts = (): Attempt[] => {
    const now = hashNow(level);
    const here = attempts.store.getState().filter(({ played, ...one }) => played.hash === now && isOurs(one.accuracy));
    return here.reverse();
  };
  /** The level with runs that complete it, its own and attempts; null if there are none. */
  const completable = (): Level | null => {
    const { level: now, provenBy } = proof.proof();
    const more = ownAttempts()
      .filter(completed)
      .map(({ number, holds }) => ({ name: `attempt ${number}`, holds: [...holds] }));
    return provenBy === null && more.length === 0 ? null : { ...now, runs: [...now.runs, ...more] as Level['runs'] };
  };
  /** The runs that fail, each once. */
  const failing = (): (readonly Hold[])[] => {
    const known = proof.proof();
    const { selected, plays, of } = shelf.store.getState();
    const isSelected = ({ number }: Attempt) => selected.has(`attempt-${number}`);
    const failed = ownAttempts().filter((one) => one.end !== null && !completed(one));
    const opened = plays.filter(
      ({ key, play, replayed }) =>
        selected.has(key) && of?.hash === hashNow(level) && isOurs(play.accuracy) && replayed?.outcome !== 'completed',
    );
    const wanted = [
      ...(isWhole(known) && known.run.outcome !== 'completed' ? [known.run.holds] : []),
      ...failed.filter(isSelected).map(({ holds }) => joinHolds(holds)),
      ...opened.map(({ play }) => joinHolds(play.holds)),
      ...failed.filter((one) => !isSelected(one)).map(({ holds }) => joinHolds(holds)),
    ];
    const once = new Map(wanted.map((holds) => [holds.join(), holds]));
    return [...once.values()].slice(0, MOST_RUNS);
  };

  const examineRuns = (from: Level, under: Terms) => {
    const name = accuracyNameOf(under);
    const traced = failing().filter((holds) => !settled.has(lossKey(holds, name)));
    const key = traced.map((holds) => lossKey(holds, name)).join(';');
    if (key === asked) return;
    runs?.cancel();
    runs = null;
    asked = key;
    if (traced.length === 0) return;
    const show = ({ losses }: Losses) => {
      const known = new Map(store.getState().losses);
      for (const [i, loss] of losses.entries()) known.set(lossKey(traced[i], name), loss);
      store.setState({ losses: known });
    };
    const mine = workers.start(jobs.losses, { level: from, terms: under, traced, effort: EFFORT_OF_RUNS }, (found) => {
      if (runs === mine) show(found);
    });
    runs = mine;
    void mine.end.then((end) => {
      if (runs !== mine || end.kind !== 'done') return;
      show(end.result);
      for (const holds of traced) settled.add(lossKey(holds, name));
    });
  };
  const examineStates = (from: Level, under: Terms, effort: number) => {
    store.setState({ phase: 'examining', message: null, effort });
    const mine = workers.start(jobs.lost, { level: from, terms: under, effort }, (losing) => {
      if (states === mine) store.setState({ losing });
    });
    states = mine;
    void mine.end.then((end) => {
      if (states !== mine) return;
      states = null;
      if (end.kind === 'done') store.setState({ phase: 'done', losing: end.result });
      else if (end.kind !== 'cancelled') store.setState({ phase: 'failed', message: end.message });
    });
  };

  const begin = () => {
    const from = completable();
    if (terms === null) return;
    if (from === null) {
      store.setState({ phase: 'needs a run' });
      return;
    }
    examineRuns(from, terms);
    const { phase } = store.getState();
    if (phase === 'waiting' || phase === 'needs a run') examineStates(from, terms, EFFORT);
  };
  const look = () => {
    const isShown = session.getState().layers.lost;
    if (!isShown) {
      if (store.getState().phase === 'off') return;
      drop();
      scene = null;
      store.setState({ phase: 'off', effort: 0, ...NOTHING_LOST }, true);
      return;
    }
    const now = proof.proof();
    if (now.scene !== scene) {
      drop();
      scene = now.scene;
      terms = now.terms;
      store.setState({ phase: 'waiting', effort: 0, ...NOTHING_LOST }, true);
    }
    forget();
    forget = afterRest(SETTLE, begin);
  };
  look();
  let layers = session.getState().layers;
  const stops = [
    proof.store.subscribe(look),
    attempts.store.subscribe(look),
    shelf.store.subscribe(look),
    session.subscribe((now) => {
      if (now.layers.lost === layers.lost) return;
      layers = now.layers;
      look();
    }),
  ];
  return {
    stop() {
      if (store.getState().phase !== 'examining') return;
      states?.cancel();
      states = null;
      store.setState({ phase: 'stopped' });
    },
    goOn() {
      const from = completable();
      if (from === null || terms === null) return;
      states?.cancel();
      const { effort, phase } = store.getState();
      examineStates(from, terms, phase === 'stopped' ? effort : MORE * effort);
    },
    close() {
      for (const stop of stops) stop();
      drop();
      store.setState({ phase: 'off', effort: 0, ...NOTHING_LOST }, true);
    },
  };
}
