// Every question of the page in every case: each is asked through workers whose ports a test plays, under a clock that it advances.

import { readdirSync, readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { describe, expect, it } from 'vitest';
import { createStore } from 'zustand/vanilla';
import type { Asked, Desk, Question } from '../../editor/core/ask/index.ts';
import { createAttempts } from '../../editor/core/attempts/attempts.ts';
import { createEditedLevel, createSelection, moveObjects } from '../../editor/core/document/index.ts';
import { pictureQuestion } from '../../editor/core/pictures/index.ts';
import { playsQuestion } from '../../editor/core/plays/open-plays.ts';
import { createProofStore, type LiveProof, slackQuestion } from '../../editor/core/proof/index.ts';
import { createSession } from '../../editor/core/session/index.ts';
import { createSettings } from '../../editor/core/settings/index.ts';
import { checkQuestion, proofQuestion } from '../../editor/core/verdict/evidence.ts';
import { accuracyQuestion, namedQuestion } from '../../editor/features/accuracy/measured-settings.ts';
import { retimeQuestion } from '../../editor/features/alive/seek-holds.ts';
import { pathQuestion } from '../../editor/features/attempts/selected-ghosts.ts';
import { comparedOf, trajectoryQuestion } from '../../editor/features/compare/compared.ts';
import { effectsQuestion } from '../../editor/features/effects/Effects.tsx';
import { comparisonQuestion } from '../../editor/features/history/use-comparison.ts';
import { leewayQuestion } from '../../editor/features/leeway/watch-leeway.ts';
import { lossesQuestion, lostQuestion } from '../../editor/features/lost/watch-lost.ts';
import { mendQuestion } from '../../editor/features/mend/watch-mend.ts';
import { gradeQuestion } from '../../editor/features/pack/grades.ts';
import { difficultyQuestion } from '../../editor/features/solver/difficulty-session.ts';
import { fixQuestion } from '../../editor/features/solver/fix-session.ts';
import { fanQuestion, robustnessQuestion } from '../../editor/features/solver/robustness-watch.ts';
import { hopelessQuestion, solveQuestion } from '../../editor/features/solver/search-task.ts';
import { createWorkers, type WorkerPort } from '../../editor/workers/index.ts';
import type { FromWorker, ToWorker } from '../../editor/workers/workers.ts';
import { ACCURACIES, DEFAULT_TERMS, type Terms } from '../../engine/index.ts';
import type { LevelFile } from '../../schema/index.ts';
import { TurnedClock } from './stage.ts';
import { SWING } from './swing-level.ts';

const OTHER_TERMS: Terms = { ...DEFAULT_TERMS, accuracy: ACCURACIES.arcade };

type AnyQuestion = Question<unknown, unknown, unknown>;

/** A question that is asked, and what a test can do to it. */
interface Staged {
  readonly own: AnyQuestion;
  /** Changes the level that it is about. */
  edit(): void;
  /** Changes the terms that it is about. */
  setTerms(): void;
}

type Stage = (desk: Desk) => Staged;

/** An open level. */
function openLevel(file: LevelFile) {
  const document = createEditedLevel(file);
  const proof = createProofStore(document, DEFAULT_TERMS);
  const session = createSession([]);
  const edit = () => void document.change('Edit', moveObjects([document.file().asteroids?.[0].id ?? ''], 1, 0));
  return { document, proof, session, edit, setTerms: () => proof.setTerms(OTHER_TERMS) };
}

/** A question that follows an open level. */
const following =
  <F>(
    ask: (desk: Desk, from: F) => Question<never, never, never>,
    from: (open: ReturnType<typeof openLevel>) => F,
    file: LevelFile = SWING,
  ): Stage =>
  (desk) => {
    const open = openLevel(file);
    return { own: ask(desk, from(open)) as unknown as AnyQuestion, edit: open.edit, setTerms: open.setTerms };
  };

/** A question about what a component wants. */
const wanted =
  <O>(ask: (desk: Desk, from: never) => Question<never, never, never>, of: (file: LevelFile, terms: Terms) => O): Stage =>
  (desk) => {
    const store = createStore<O | null>(() => of(SWING, DEFAULT_TERMS));
    const want = (file: LevelFile, terms: Terms) => store.setState(of(file, terms), true);
    return {
      own: ask(desk, store as never) as unknown as AnyQuestion,
      edit: () => want({ ...SWING, name: 'Edited' }, DEFAULT_TERMS),
      setTerms: () => want(SWING, OTHER_TERMS),
    };
  };

/** A question that is asked on demand: an edit asks again. */
const onDemand =
  <O>(ask: (desk: Desk) => Question<never, never, never>, of: (file: LevelFile, terms: Terms) => O): Stage =>
  (desk) => {
    const own = ask(desk) as unknown as AnyQuestion;
    own.ask(of(SWING, DEFAULT_TERMS));
    return {
      own,
      edit: () => own.ask(of({ ...SWING, name: 'Edited' }, DEFAULT_TERMS)),
      setTerms: () => own.ask(of(SWING, OTHER_TERMS)),
    };
  };

const asked = (level: LevelFile, terms: Terms) => ({ level, terms });
const ANY = { minerals: 'any' } as const;
const FAILS: LevelFile = { ...SWING, runs: [...(SWING.runs ?? []), { name: 'fails', holds: [] }] };

const withLayer = (layer: 'lost' | 'leeway', { session }: Pick<ReturnType<typeof openLevel>, 'session'>) =>
  session.setState(({ layers }) => ({ layers: { ...layers, [layer]: true } }));

/** A proof that has left something out. */
const tooMuch = ({ proof }: ReturnType<typeof openLevel>) => {
  const limited = (): LiveProof => ({ ...proof.proof(), limit: 'others' });
  return { ...proof, proof: limited };
};

const lostFrom = (open: ReturnType<typeof openLevel>) => {
  withLayer('lost', open);
  open.session.subscribe(({ run }) => open.proof.showRun(run));
  open.session.setState({ run: 'fails' });
  return { level: { ...open, attempts: createAttempts() }, session: open.session, finished: new Set<string>() };
};

const STAGES: Readonly<Record<string, Stage>> = {
  accuracyQuestion: onDemand(accuracyQuestion as never, asked),
  checkQuestion: following(checkQuestion as never, tooMuch),
  comparisonQuestion: wanted(comparisonQuestion as never, asked),
  difficultyQuestion: onDemand(difficultyQuestion as never, asked),
  effectsQuestion: onDemand(effectsQuestion as never, (level, terms) => ({ level, terms, holds: [] })),
  fanQuestion: following(fanQuestion as never, ({ proof }) => ({ proof, withMinerals: createStore(() => false) })),
  fixQuestion: onDemand(fixQuestion as never, asked),
  gradeQuestion: onDemand(gradeQuestion as never, asked),
  hopelessQuestion: onDemand(hopelessQuestion as never, asked),
  leewayQuestion: following(leewayQuestion as never, (open) => {
    withLayer('leeway', open);
    const selection = createSelection(open.document);
    selection.select([open.document.file().asteroids?.[0].id ?? '']);
    const seen = { now: () => ({ left: 0, top: 0, right: 900, bottom: 900 }), subscribe: () => () => {} };
    return { level: { ...open, selection }, session: open.session, settings: createSettings(null), seen };
  }),
  namedQuestion: following(namedQuestion as never, ({ proof }) => proof),
  lossesQuestion: following(lossesQuestion as never, lostFrom, FAILS),
  lostQuestion: following(lostQuestion as never, lostFrom, FAILS),
  mendQuestion: onDemand(mendQuestion as never, asked),
  pathQuestion: onDemand(pathQuestion as never, asked),
  pictureQuestion: wanted(pictureQuestion as never, asked),
  playsQuestion: onDemand(playsQuestion as never, asked),
  proofQuestion: following(proofQuestion as never, ({ proof }) => proof, {
    ...SWING,
    blackHole: { ...SWING.blackHole, x: 9000 },
  }),
  retimeQuestion: onDemand(retimeQuestion as never, (file, terms) => ({
    about: { file, level: file, terms },
    former: { name: 'run', holds: [], tick: 100, minerals: [] },
    ...{ warm: null, effort: 1, certifies: false },
  })),
  robustnessQuestion: (desk) => {
    const open = openLevel(SWING);
    const done = (): Partial<Asked<unknown, unknown>> => ({
      phase: 'done',
      of: { known: open.proof.proof(), withMinerals: false },
      gaveUp: false,
    });
    const store = createStore<Partial<Asked<unknown, unknown>>>(done);
    open.proof.store.subscribe(() => store.setState(done()));
    return {
      own: robustnessQuestion(desk, { store } as never) as unknown as AnyQuestion,
      edit: open.edit,
      setTerms: open.setTerms,
    };
  },
  slackQuestion: wanted(slackQuestion as never, (level, terms) => ({ of: {}, level, terms, holds: [], goal: ANY })),
  solveQuestion: onDemand(solveQuestion as never, asked),
  trajectoryQuestion: following(
    trajectoryQuestion as never,
    (open) => {
      const level = { ...open, attempts: createAttempts() };
      const store = comparedOf(level);
      store.setState({ runs: [{ source: { kind: 'run', name: 'fails' }, slot: 0 }] });
      return { level, store, asked: new Map() };
    },
    FAILS,
  ),
};

/** Those that go on when the level changes: each answer is taken, and the next is asked for after it. */
const IN_PACE = new Set(['trajectoryQuestion']);

/** A page with workers whose ports a test plays. */
function page(name: string) {
  const clock = new TurnedClock();
  const ports: {
    answer: (message: FromWorker) => void;
    die: (reason: string) => void;
    readonly sent: ToWorker[];
    isOver: boolean;
  }[] = [];
  const spawn = (): WorkerPort => {
    const port: (typeof ports)[number] = { sent: [], isOver: false, answer: () => {}, die: () => {} };
    ports.push(port);
    return {
      postMessage: (message) => void port.sent.push(message),
      onMessage: (listener) => {
        port.answer = listener;
      },
      onDeath: (listener) => {
        port.die = listener;
      },
      terminate: () => {
        port.isOver = true;
      },
    };
  };
  const after = (ms: number, call: () => void) => clock.after(ms, call);
  const workers = createWorkers({ spawn, after });
  const staged = STAGES[name]({ workers, afterRest: after, after });
  /** All requests so far, the last one last, and where they were sent. */
  const requests = () =>
    ports
      .flatMap((port) => port.sent.flatMap((message) => (message.type === 'start' ? [{ ...message, port }] : [])))
      .sort((a, b) => a.job - b.job);
  const cancels = () => ports.flatMap(({ sent }) => sent.flatMap((message) => (message.type === 'cancel' ? [message.job] : [])));
  return {
    ...staged,
    ...{ clock, workers, requests, cancels },
    state: () => staged.own.store.getState(),
    /** Everything that is waited for has come. */
    async rest() {
      await clock.pass(1000);
      return requests().at(-1) as ReturnType<typeof requests>[number];
    },
    /** A worker reports, answers or fails. */
    async says(request: ReturnType<typeof requests>[number], message: object) {
      request.port.answer({ job: request.job, ...message } as FromWorker);
      await clock.pass(0);
    },
  };
}

const names = Object.keys(STAGES);

it('every question of the page is staged here', () => {
  const editor = join(dirname(fileURLToPath(import.meta.url)), '..', '..', 'editor');
  const found = readdirSync(editor, { recursive: true, encoding: 'utf8' })
    .filter((path) => /\.tsx?$/.test(path))
    .flatMap((path) => [...readFileSync(join(editor, path), 'utf8').matchAll(/const (\w+)\s*=\s*(?:question|onDemand)\(/g)])
    .map(([, name]) => name);
  expect(found.sort()).toEqual([...names].sort());
});

describe.each(names)('%s', (name) => {
  it('is asked once, reports, and answers', async () => {
    const { rest, says, state, requests } = page(name);
    const request = await rest();
    expect(requests()).toHaveLength(1);
    expect(state()).toMatchObject({ phase: 'asking', progress: null, answer: null });
    await says(request, { type: 'progress', progress: 'some' });
    expect(state()).toMatchObject({ phase: 'asking', progress: 'some', answer: null });
    await says(request, { type: 'done', result: 'all' });
    expect(state()).toMatchObject({ phase: 'done', answer: 'all', message: null });
    await rest();
    expect(requests()).toHaveLength(1);
  });

  it('is asked anew when the level is edited, and drops what it is told of the level before', async () => {
    const { rest, says, state, edit, requests, cancels } = page(name);
    const first = await rest();
    await says(first, { type: 'progress', progress: 'old' });
    edit();
    if (IN_PACE.has(name)) {
      expect(cancels()).toEqual([]);
      await says(first, { type: 'done', result: 'old' });
    } else {
      expect(cancels()).toEqual([first.job]);
      expect(state()).toMatchObject({ progress: null, answer: null });
      await says(first, { type: 'progress', progress: 'late' });
      await says(first, { type: 'done', result: 'late' });
      expect(state()).toMatchObject({ progress: null, answer: null });
    }
    const second = await rest();
    expect(requests()).toHaveLength(2);
    expect(second.request).not.toEqual(first.request);
    await says(second, { type: 'done', result: 'new' });
    expect(state()).toMatchObject({ phase: 'done', answer: 'new' });
  });

  it('is asked anew when it is edited after the answer', async () => {
    const { rest, says, state, edit, requests } = page(name);
    await says(await rest(), { type: 'done', result: 'old' });
    edit();
    const second = await rest();
    expect(requests()).toHaveLength(2);
    expect(state()).toMatchObject({ phase: 'asking', answer: null });
    await says(second, { type: 'done', result: 'new' });
    expect(state()).toMatchObject({ phase: 'done', answer: 'new' });
  });

  it('is asked under the terms of the moment', async () => {
    const { rest, says, setTerms } = page(name);
    const first = await rest();
    await says(first, { type: 'done', result: 'usual' });
    setTerms();
    const second = await rest();
    expect([first.request, second.request]).toMatchObject([{ terms: DEFAULT_TERMS }, { terms: OTHER_TERMS }]);
  });

  it('is cancelled by hand, keeps what is known, and hears nothing more', async () => {
    const { own, rest, says, state, requests, cancels } = page(name);
    const request = await rest();
    await says(request, { type: 'progress', progress: 'some' });
    own.stop();
    expect(cancels()).toEqual([request.job]);
    await says(request, { type: 'done', result: 'late' });
    expect(state()).toMatchObject({ phase: 'stopped', progress: 'some', answer: null });
    await rest();
    expect(requests()).toHaveLength(1);
  });

  it('is forgotten', async () => {
    const { own, rest, says, state, cancels } = page(name);
    const request = await rest();
    await says(request, { type: 'progress', progress: 'some' });
    own.forget();
    expect(cancels()).toEqual([request.job]);
    expect(state()).toMatchObject({ phase: 'idle', of: null, progress: null });
  });

  it('says why the job failed, and is asked again once the level is edited', async () => {
    const { rest, says, state, edit, requests } = page(name);
    await says(await rest(), { type: 'failed', message: 'no such thing' });
    expect(state()).toMatchObject({ phase: 'failed', message: 'no such thing', gaveUp: false, answer: null });
    await rest();
    expect(requests()).toHaveLength(1);
    edit();
    await says(await rest(), { type: 'done', result: 'all' });
    expect(state()).toMatchObject({ phase: 'done', answer: 'all', message: null });
  });

  it('survives the death of a worker: another one answers the next time', async () => {
    const { rest, says, state, edit, clock } = page(name);
    const first = await rest();
    first.port.die('out of memory');
    await clock.pass(0);
    expect(state()).toMatchObject({ phase: 'failed', message: 'out of memory', gaveUp: false });
    expect(first.port.isOver).toBe(true);
    edit();
    const second = await rest();
    expect(second.port).not.toBe(first.port);
    await says(second, { type: 'done', result: 'all' });
    expect(state()).toMatchObject({ phase: 'done', answer: 'all' });
  });

  it('says so when the job takes too much work, if it has a limit of its own', async () => {
    const { rest, state, clock } = page(name);
    const { port } = await rest();
    await clock.pass(200_000);
    const { phase, gaveUp, message } = state();
    if (phase === 'asking') expect(port.isOver).toBe(false);
    else
      expect({ phase, gaveUp, message }).toMatchObject({
        phase: 'failed',
        gaveUp: true,
        message: expect.stringContaining('work limit'),
      });
  });

  it('ends with the level or the component: what is asked is cancelled, and nothing is heard or asked any more', async () => {
    const { own, rest, says, state, edit, requests, cancels } = page(name);
    const request = await rest();
    own.close();
    expect(cancels()).toEqual([request.job]);
    const before = state();
    await says(request, { type: 'progress', progress: 'late' });
    await says(request, { type: 'done', result: 'late' });
    expect(state()).toBe(before);
    // one on demand is asked again by who wants it
    if (!isFollowing(name)) return;
    edit();
    await rest();
    expect(requests()).toHaveLength(1);
  });

  it('is not asked at all if it ends while it waits', async () => {
    const { own, rest, requests } = page(name);
    if (!isFollowing(name)) return;
    own.close();
    await rest();
    expect(requests()).toEqual([]);
  });
});

/** Whether it waits for the page before it asks. */
function isFollowing(name: string): boolean {
  const { requests, own } = page(name);
  own.close();
  return requests().length === 0;
}
