import { type AccuracyName, joinHolds, type Scene, type Terms } from '../../../engine/index.ts';
import type { Hold, Level } from '../../../schema/index.ts';
import { type Desk, question } from '../../core/ask/index.ts';
import type { Attempt } from '../../core/attempts/index.ts';
import { type OpenLevel, ofLevel } from '../../core/context/index.ts';
import { isWhole } from '../../core/proof/index.ts';
import type { SessionStore } from '../../core/session/index.ts';
import { hashNow, shelfOf } from '../../core/shelf/index.ts';
import { accuracyNameOf, jobs } from '../../workers/index.ts';
import { lossKey, lostOf, NOTHING_LOST } from './index.ts';

/** Shows or hides the shade. */
export const LOST_KEY = 'l';

/** Ticks for the states, as `gq check --softlocks` takes by default, and the factor of a search that goes on. */
export const EFFORT = 10_000_000;
const MORE = 4;

/** Ticks for the losses of all runs that are examined at once. */
const EFFORT_OF_RUNS = 20_000_000;

/** At most so many runs that fail are examined: the shown one, then the attempts, those that are selected first. */
const MOST_RUNS = 12;

/** The examination of where one level is already lost. */
export interface LostSession {
  /** Stops the examination and keeps what it has found. */
  stop(): void;
  /** Examines again, with several times the effort. */
  goOn(): void;
  close(): void;
}

interface LostParts {
  readonly level: LostLevel;
  readonly session: SessionStore;
  readonly desk: Desk;
}

type LostLevel = Pick<OpenLevel, 'document' | 'proof' | 'attempts'>;

const completed = ({ end }: Attempt): boolean => end?.outcome === 'completed';

/** The level under terms, and what it takes time to say of it, found out once if at all. */
interface Examined {
  readonly scene: Scene;
  readonly terms: Terms;
  /** With runs that complete it, its own and attempts; null if there are none. */
  readonly level: () => Level | null;
  /** The runs that fail, each once. */
  readonly failing: () => readonly (readonly Hold[])[];
}

const once = <T>(make: () => T): (() => T) => {
  let made: { readonly value: T } | null = null;
  return () => {
    made ??= { value: make() };
    return made.value;
  };
};

/** The level as it is now. */
function examinedNow(level: LostLevel): Examined {
  const known = level.proof.proof();
  const { scene, terms } = known;
  const isOurs = (accuracy: AccuracyName): boolean => accuracy === terms.accuracy.name;
  const all = level.attempts.store.getState();
  const { selected, plays, of } = shelfOf(level).store.getState();
  const hash = once(() => hashNow({ proof: level.proof }));
  /** The attempts at the level as it is now, the latest first. */
  const own = once(() => all.filter(({ played, ...one }) => played.hash === hash() && isOurs(one.accuracy)).reverse());
  return {
    scene,
    terms,
    level: once(() => {
      const more = own()
        .filter(completed)
        .map(({ number, holds }) => ({ name: `attempt ${number}`, holds: [...holds] }));
      if (known.provenBy === null && more.length === 0) return null;
      return { ...known.level, runs: [...known.level.runs, ...more] as Level['runs'] };
    }),
    failing: once(() => {
      const isSelected = ({ number }: Attempt) => selected.has(`attempt-${number}`);
      const failed = own().filter((one) => one.end !== null && !completed(one));
      const opened = plays.filter(
        ({ key, play, replayed }) =>
          selected.has(key) && of?.hash === hash() && isOurs(play.accuracy) && replayed?.outcome !== 'completed',
      );
      const wanted = [
        ...(isWhole(known) && known.run.outcome !== 'completed' ? [known.run.holds] : []),
        ...failed.filter(isSelected).map(({ holds }) => joinHolds(holds)),
        ...opened.map(({ play }) => joinHolds(play.holds)),
        ...failed.filter((one) => !isSelected(one)).map(({ holds }) => joinHolds(holds)),
      ];
      return [...new Map(wanted.map((holds) => [holds.join(), holds])).values()].slice(0, MOST_RUNS);
    }),
  };
}

interface Shade {
  readonly level: LostLevel;
  readonly session: SessionStore;
}

const whenShown = ({ session }: Shade, look: () => void): (() => void) =>
  session.subscribe((now, before) => {
    if (now.layers.lost !== before.layers.lost) look();
  });

/** What decides what is lost: the level, and runs that come and go. */
const changesOf = (from: Shade) => [
  from.level.proof.store.subscribe,
  from.level.attempts.store.subscribe,
  shelfOf(from.level).store.subscribe,
  (look: () => void) => whenShown(from, look),
];

/** Where the level is already lost, with so much effort, ticks. */
export const lostQuestion = question({
  job: jobs.lost,
  request({ level, terms, effort }: Examined & { readonly effort: number }) {
    const from = level();
    return from === null ? null : { level: from, terms, effort };
  },
  follows: {
    wait: { rest: 500 },
    of: ({ level, session }: Shade) => (session.getState().layers.lost ? { ...examinedNow(level), effort: EFFORT } : null),
    // without a run that completes the level everything could be lost, so the first one matters
    same: (asked, now) => asked.scene === now.scene && (asked.level() !== null || now.level() === null),
    on: changesOf,
  },
});

/** The runs of which it is asked since when they were lost. */
interface Traced extends Examined {
  readonly traced: () => readonly (readonly Hold[])[];
}

interface Losers extends Shade {
  /** The runs of which nothing more is found, by {@link lossKey}. */
  readonly finished: ReadonlySet<string>;
}

const tracedKey = ({ level, traced }: Traced): string => (level() === null ? '' : traced().join(';'));

/** Since when runs were lost that fail. */
export const lossesQuestion = question({
  job: jobs.losses,
  request({ level, terms, traced }: Traced) {
    const from = level();
    return from === null || traced().length === 0 ? null : { level: from, terms, traced: traced(), effort: EFFORT_OF_RUNS };
  },
  follows: {
    wait: { rest: 500 },
    of({ level, session, finished }: Losers): Traced | null {
      if (!session.getState().layers.lost) return null;
      const examined = examinedNow(level);
      const name = accuracyNameOf(examined.terms);
      return { ...examined, traced: once(() => examined.failing().filter((holds) => !finished.has(lossKey(holds, name)))) };
    },
    same: (asked, now) => asked.scene === now.scene && tracedKey(asked) === tracedKey(now),
    on: changesOf,
  },
});

const PHASES = { idle: 'off', nothing: 'needs a run', asking: 'examining' } as const;

/**
 * While the layer is shown, examines where the level is already lost, and since when the shown run and attempts were lost. What
 * was found is thrown away when the level changes.
 */
export function watchLost({ level, session, desk }: LostParts): LostSession {
  const store = lostOf(level);
  const finished = new Set<string>();
  const states = lostQuestion(desk, { level, session });
  const runs = lossesQuestion(desk, { level, session, finished });
  let scene: Scene | null = null;

  const show = () => {
    const { phase, of, progress, answer, message } = states.store.getState();
    if (of === null || of.scene !== scene) {
      scene = of?.scene ?? null;
      finished.clear();
      store.setState(NOTHING_LOST);
    }
    const isAsked = phase !== 'idle' && phase !== 'waiting' && phase !== 'nothing';
    const losing = answer ?? progress ?? store.getState().losing;
    const is = phase === 'idle' || phase === 'nothing' || phase === 'asking' ? PHASES[phase] : phase;
    store.setState({ phase: is, message, losing, effort: isAsked && of !== null ? of.effort : 0 });
  };
  show();
  const stops = [
    states.store.subscribe(show),
    runs.store.subscribe(({ of, progress, answer, phase }) => {
      const found = answer ?? progress;
      if (of === null || found === null || of.scene !== scene) return;
      const name = accuracyNameOf(of.terms);
      const known = new Map(store.getState().losses);
      for (const [i, loss] of found.losses.entries()) known.set(lossKey(of.traced()[i], name), loss);
      store.setState({ losses: known });
      if (phase === 'done') for (const holds of of.traced()) finished.add(lossKey(holds, name));
    }),
  ];
  return {
    stop() {
      if (states.store.getState().phase === 'asking') states.stop();
    },
    goOn() {
      const { phase, of } = states.store.getState();
      if (of === null) return;
      states.ask({ ...examinedNow(level), effort: phase === 'stopped' ? of.effort : MORE * of.effort });
    },
    close() {
      for (const stop of stops) stop();
      states.close();
      runs.close();
      store.setState({ phase: 'off', effort: 0, ...NOTHING_LOST }, true);
    },
  };
}

/** The examination of where an open level is already lost. */
export const lostSessionOf = ofLevel<LostSession>(({ session, desk }, level) => watchLost({ level, session, desk }));
