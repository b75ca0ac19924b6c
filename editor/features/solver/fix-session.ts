import { createStore, type StoreApi } from 'zustand/vanilla';
import { repairedFile } from '../../../check/index.ts';
import { proposalInWords } from '../../../check/words/index.ts';
import type { Level } from '../../../schema/index.ts';
import type { Proposal } from '../../../solver/index.ts';
import { type Desk, onDemand } from '../../core/ask/index.ts';
import type { OpenLevel } from '../../core/context/index.ts';
import { freeRunName } from '../../core/document/index.ts';
import { createPreview, type SessionStore } from '../../core/session/index.ts';
import { type Fixing, jobs } from '../../workers/index.ts';
import { SOLUTION } from './search-session.ts';
import type { SearchSettingsStore } from './search-task.ts';

export interface FixState {
  readonly phase: 'idle' | 'seeking' | 'done' | 'failed';
  readonly message: string | null;
  readonly fixing: Fixing | null;
  /** The level that the proposals are for. */
  readonly level: Level | null;
  /** The proposal that the page shows as if it were taken. */
  readonly previewed: Proposal | null;
  /** Whether the level has changed since: the proposals are not for it. */
  readonly isOld: boolean;
}

/** Proposals that make the level completable, on demand. */
export interface FixSession {
  readonly store: StoreApi<FixState>;
  start(): void;
  /** Stops the search and keeps the proposals. */
  cancel(): void;
  /** Shows the level as a proposal makes it, in place of one that is previewed. Nothing is saved yet. */
  preview(proposal: Proposal): void;
  /** Keeps the previewed proposal, as one step of the history. */
  take(): void;
  /** Shows the level as it was before the preview. */
  back(): void;
  close(): void;
}

interface FixParts {
  readonly level: Pick<OpenLevel, 'document' | 'proof'>;
  readonly session: SessionStore;
  readonly desk: Desk;
  readonly settings: SearchSettingsStore;
}

/** Changes that make a level completable. */
export const fixQuestion = onDemand(jobs.fix);

const IDLE: FixState = { phase: 'idle', message: null, fixing: null, level: null, previewed: null, isOld: false };

/** Seeks proposals for one level. A preview is a change in progress, as while an object is dragged. */
export function createFixSession({ level: { document, proof }, session, desk, settings }: FixParts): FixSession {
  const store = createStore<FixState>(() => IDLE);
  const fixes = fixQuestion(desk);
  const preview = createPreview(document, session);

  const back = () => {
    preview.back();
    if (store.getState().previewed !== null) store.setState({ previewed: null });
  };
  // a step of the history, also one that takes the preview along
  const stop = document.onStep(() => {
    const { phase, fixing } = store.getState();
    preview.ended();
    fixes.forget();
    store.setState({ previewed: null, isOld: fixing !== null, phase: phase === 'seeking' ? 'done' : phase });
  });

  return {
    store,
    start() {
      back();
      fixes.forget();
      const { level, terms } = proof.proof();
      store.setState({ ...IDLE, phase: 'seeking', level });
      const { seed, budget } = settings.getState();
      fixes.ask({ level, terms, seed, budget: 1000 * budget }, ({ phase, progress, answer, message }) => {
        // the list does not move while one of it is previewed
        const isFree = store.getState().previewed === null;
        if (phase === 'failed') store.setState({ phase, message });
        else if (isFree) store.setState({ fixing: answer ?? progress });
        if (phase === 'done') store.setState({ phase });
      });
    },
    cancel() {
      fixes.forget();
      store.setState(({ fixing }) => ({ phase: fixing === null ? 'idle' : 'done' }));
    },
    preview(proposal) {
      const { level, isOld } = store.getState();
      if (level === null || isOld) return;
      back();
      const file = document.file();
      const name = freeRunName(file, SOLUTION);
      const { origin } = proposal;
      const run = origin.from === 'search' ? name : level.runs[origin.index].name;
      const label = proposalInWords(level, proposal).replace(/\.$/, '');
      preview.show(label, (draft) => void Object.assign(draft, repairedFile(file, proposal, name)), run);
      store.setState({ previewed: proposal });
    },
    take: preview.take,
    back,
    close() {
      stop();
      fixes.forget();
      back();
    },
  };
}
