import { createStore, type StoreApi } from 'zustand/vanilla';
import { type Mended, mendedInWords } from '../../../check/index.ts';
import { outcomeAsPredicate } from '../../../check/words/index.ts';
import { joinHolds, simulate } from '../../../engine/index.ts';
import type { LevelFile } from '../../../schema/index.ts';
import { type Desk, onDemand } from '../../core/ask/index.ts';
import type { OpenLevel } from '../../core/context/index.ts';
import { type DocumentEvent, freeRunName, type Recipe, type StepMark } from '../../core/document/index.ts';
import type { LiveProof } from '../../core/proof/index.ts';
import { createPreview, type SessionStore } from '../../core/session/index.ts';
import type { SettingsStore } from '../../core/settings/index.ts';
import { jobs, type Mending } from '../../workers/index.ts';
import type { AliveState } from '../alive/index.ts';

/** Seeks what mends the level. */
export const MEND_KEY = 'Shift+m';

/** ms without a change before a broken level is spoken of: numbers are typed digit by digit */
const REST = 400;

/** The name of a run that is added. */
const FOUND = 'solution';

export interface MendState {
  /** `offered`: the last change broke the level. The other phases follow when that is to be mended. */
  readonly phase: 'none' | 'offered' | 'seeking' | 'done' | 'failed';
  /** What the change broke, as a sentence. */
  readonly sentence: string;
  readonly mending: Mending | null;
  /** What the page shows as if it were taken. */
  readonly previewed: Mended | null;
  /** The file that is mended; null while nothing is offered. */
  readonly after: LevelFile | null;
}

/** The offer to mend what the last change broke. */
export interface MendSession {
  readonly store: StoreApi<MendState>;
  /** Seeks what mends the level. */
  start(): void;
  /** Shows the level as one of the finds makes it, in place of one that is previewed. Nothing is saved yet. */
  preview(mended: Mended): void;
  /** Keeps what is previewed, as one step of the history. */
  take(): void;
  /** Shows the level as it was before the preview. */
  back(): void;
  /** Goes back from a preview; without one, dismisses the offer. */
  leave(): void;
  dismiss(): void;
}

interface MendParts {
  readonly level: Pick<OpenLevel, 'document' | 'proof'>;
  readonly session: SessionStore;
  readonly settings: SettingsStore;
  readonly desk: Desk;
  /** What is done to keep the run alive, which comes first. */
  readonly alive: StoreApi<AliveState>;
}

/** What mends a level that a change has broken. */
export const mendQuestion = onDemand(jobs.mend);

const NONE: MendState = { phase: 'none', sentence: '', mending: null, previewed: null, after: null };

const sessions = new WeakMap<object, MendSession>();

/** The offer to mend an open level; null if nothing watches it. */
export const mendSessionOf = ({ document }: Pick<OpenLevel, 'document'>): MendSession | null => sessions.get(document) ?? null;

/** The run that completes the level; null if none does or that is not known. */
const provenBy = ({ verdict, provenBy: run }: LiveProof): string | null => (verdict === 'completable' ? run : null);

/** What became of a run, as a sentence. */
function brokenInWords({ scene, level }: LiveProof, name: string): string {
  const holds = level.runs.find((run) => run.name === name)?.holds ?? [];
  const end = outcomeAsPredicate(simulate(scene, joinHolds(holds)), level.range);
  return `Run ${JSON.stringify(name)} no longer completes the level: she ${end}.`;
}

/**
 * Offers to mend the level when a finished change has broken it. The offer is gone as soon as the level changes.
 * @returns stops it
 */
export function watchMend({ level, session, settings, desk, alive }: MendParts): () => void {
  const { document, proof } = level;
  const store = createStore<MendState>(() => NONE);
  /** The run that completed each file that was shown. */
  const proven = new WeakMap<LevelFile, string | null>();
  /** The last step, while it is not known whether it is to be spoken of. */
  let pending: { readonly start: LevelFile; readonly step: StepMark } | null = null;
  /** What was broken. */
  let broken: { readonly start: LevelFile; readonly run: string } | null = null;
  const mending = mendQuestion(desk);
  const preview = createPreview(document, session);
  let forget = () => {};

  const clear = () => {
    forget();
    mending.forget();
    pending = null;
    broken = null;
    if (store.getState() !== NONE) store.setState(NONE, true);
  };
  const remember = (now: LiveProof) => {
    proven.set(now.file, provenBy(now));
    // by other terms
    if (!preview.isShown() && now.verdict === 'completable' && broken !== null) clear();
  };
  const back = () => {
    if (!preview.isShown()) return;
    store.setState({ previewed: null });
    preview.back();
  };
  const isBeingKeptAlive = () => {
    const state = alive.getState();
    if (!settings.getState().keepAlive) return false;
    return state.kind === 'working' || ((state.kind === 'alive' || state.kind === 'failed') && !state.isFinal);
  };
  const consider = () => {
    if (pending === null || isBeingKeptAlive()) return;
    forget();
    forget = desk.afterRest(REST, () => {
      const now = proof.proof();
      if (pending === null || isBeingKeptAlive() || document.lastStep() !== pending.step) return;
      const { start } = pending;
      if (document.gesture() !== null) {
        consider();
        return;
      }
      pending = null;
      const run = proven.get(start) ?? null;
      if (run === null || now.verdict !== 'broken' || !now.level.runs.some(({ name }) => name === run)) return;
      broken = { start, run };
      store.setState({ ...NONE, phase: 'offered', sentence: brokenInWords(now, run), after: now.file }, true);
    });
  };
  const look = () => {
    // what is previewed is a change in progress of its own
    if (!preview.isShown()) clear();
  };
  const finish = ({ kind, how, start }: DocumentEvent) => {
    preview.ended();
    clear();
    const step = document.lastStep();
    if (kind !== 'change' || how === 'replaced' || step === null) return;
    pending = { start, step };
    consider();
  };

  const own: MendSession = {
    store,
    start() {
      const { after, phase } = store.getState();
      if (broken === null || after === null || phase === 'seeking') return;
      back();
      const { terms } = proof.proof();
      const newRun = freeRunName(after, FOUND);
      store.setState({ phase: 'seeking', mending: null });
      mending.ask({ before: broken.start, after, terms, run: broken.run, newRun }, ({ phase, progress, answer }) => {
        if (phase === 'asking') store.setState({ mending: progress });
        else store.setState(phase === 'done' ? { phase: 'done', mending: answer } : { phase: 'failed' });
      });
    },
    preview(mended) {
      const { after } = store.getState();
      if (after === null) return;
      back();
      const recipe: Recipe = (draft) => {
        for (const key of Object.keys(draft)) if (!Object.hasOwn(mended.file, key)) delete draft[key as never];
        Object.assign(draft, mended.file);
      };
      preview.show(mendedInWords(mended, after).replace(/\.$/, ''), recipe, mended.run);
      store.setState({ previewed: mended });
    },
    take: preview.take,
    back,
    leave: () => (preview.isShown() ? back() : clear()),
    dismiss() {
      back();
      clear();
    },
  };
  sessions.set(document, own);
  const stops = [proof.store.subscribe(remember), document.subscribe(look), document.onStep(finish), alive.subscribe(consider)];
  remember(proof.proof());
  return () => {
    for (const stop of stops) stop();
    own.dismiss();
    sessions.delete(document);
  };
}
