import { type ComponentType, useCallback, useEffect, useState } from 'react';
import { useStore } from 'zustand';
import { createStore, type StoreApi } from 'zustand/vanilla';
import { type Editor, useEditor, useSession } from '../context/index.ts';
import type { Session } from '../session/index.ts';
import { Button, Dialog } from '../ui/index.ts';
import './later.css';

// Parts of the page whose scripts are not there from the beginning: they come once the level is drawn, or when they are wanted before.

/** What is known of a part. */
interface Part<P> {
  /** null: it is not there yet. */
  readonly component: ComponentType<P> | null;
  /** Whether the last attempt to load it has failed, when somebody wanted it. */
  readonly hasFailed: boolean;
}

interface Later<P> {
  readonly store: StoreApi<Part<P>>;
  /** Loads it, unless it is there or under way. Never fails: the store says how it went. @param ahead whether nobody wants it yet */
  load(ahead?: boolean): Promise<void>;
}

/** All of them, in the order in which they are declared. */
const parts: ((ahead: boolean) => Promise<void>)[] = [];

function later<P>(fetch: () => Promise<ComponentType<P>>): Later<P> {
  const store = createStore<Part<P>>(() => ({ component: null, hasFailed: false }));
  let loading: Promise<void> | null = null;
  let isWanted = false;
  const load = (ahead = false) => {
    isWanted ||= !ahead;
    loading ??= fetch().then(
      (component) => store.setState({ component, hasFailed: false }),
      () => {
        loading = null;
        store.setState({ hasFailed: isWanted });
      },
    );
    return loading;
  };
  parts.push(load);
  return { store, load };
}

/** ms that a page may be busy before the next part is loaded all the same */
const PATIENCE = 1000;

/** Resolves once the page has nothing else to do. */
const idle = (): Promise<void> =>
  new Promise((resolve) => {
    // Safari has no idle callbacks
    if (typeof requestIdleCallback === 'undefined') setTimeout(resolve);
    else requestIdleCallback(() => resolve(), { timeout: PATIENCE });
  });

/** Loads all parts, one after another, while the page is idle. One that can't be loaded is tried again when it is wanted. */
export async function loadParts(): Promise<void> {
  for (const load of parts) {
    await idle();
    await load(true);
  }
}

const WHY = 'This part of the page could not be loaded: its server does not answer, or has another version of it by now.';
const REMEDY = 'Start gq edit again if it has ended, then try again. Or reload the page: your changes are kept.';

/** Imports what an action needs. @returns null if that fails, which a notice says */
export async function fetched<T>({ notices }: Pick<Editor, 'notices'>, fetch: () => Promise<T>): Promise<T | null> {
  try {
    return await fetch();
  } catch {
    notices.show('error', `${WHY} ${REMEDY}`, { topic: 'later' });
    return null;
  }
}

function Again({ load }: Pick<Later<never>, 'load'>) {
  return (
    <div className="form__buttons">
      <Button hint="Load the page again" look="outlined" onClick={() => window.location.reload()}>
        Reload
      </Button>
      <Button hint="Load this part of the page" look="main" onClick={() => void load()}>
        Try again
      </Button>
    </div>
  );
}

/** What is seen of a part until it is there; at once it would only flicker. */
const Coming = ({ look }: { readonly look: 'panel' | 'cover' }) => (
  <div className={`coming coming--${look}`} role="status">
    Loading…
  </div>
);

interface PanelProps<P> {
  readonly part: Later<P>;
  readonly given: P;
  readonly isSeen: boolean;
}

function Panel<P extends object>({ part, given, isSeen }: PanelProps<P>) {
  const { store, load } = part;
  const { component: There, hasFailed } = useStore(store);
  useEffect(() => void load(), [load]);
  if (There !== null) return <There {...given} />;
  if (!hasFailed) return isSeen ? <Coming look="panel" /> : null;
  return (
    <div className="panel__body" role="alert">
      <p>{WHY}</p>
      <p>{REMEDY}</p>
      <Again load={load} />
    </div>
  );
}

interface CoverProps<P> {
  readonly part: Later<P>;
  readonly given: P;
  readonly isWanted: boolean;
  readonly close: () => void;
}

function Cover<P extends object>({ part: { store, load }, given, isWanted, close }: CoverProps<P>) {
  const { component: There, hasFailed } = useStore(store);
  useEffect(() => {
    if (isWanted) void load();
  }, [isWanted, load]);
  const isComing = isWanted && There === null && !hasFailed;
  useEffect(() => {
    if (!isComing) return;
    // what is typed is meant for what is coming, and must not act on the page; Esc takes it back
    const keep = (event: KeyboardEvent) => {
      event.preventDefault();
      event.stopPropagation();
      if (event.key === 'Escape') close();
    };
    window.addEventListener('keydown', keep, { capture: true });
    return () => window.removeEventListener('keydown', keep, { capture: true });
  }, [isComing, close]);
  if (There !== null) return <There {...given} />;
  if (isComing) return <Coming look="cover" />;
  return (
    <Dialog open={isWanted && hasFailed} title="Not loaded" about={WHY} onClose={close}>
      <p>{REMEDY}</p>
      <Again load={load} />
    </Dialog>
  );
}

/** A panel: it is wanted as soon as it is rendered, and a placeholder fills its place until then. @param fetch imports it */
export function laterPanel<P extends object>(fetch: () => Promise<ComponentType<P>>): ComponentType<P> {
  const part = later(fetch);
  return (given) => <Panel part={part} given={given} isSeen />;
}

/** Another part that is wanted as soon as it is rendered; nothing is in its place until then. @param fetch imports it */
export function laterPart<P extends object>(fetch: () => Promise<ComponentType<P>>): ComponentType<P> {
  const part = later(fetch);
  return (given) => <Panel part={part} given={given} isSeen={false} />;
}

/** A part that is wanted once it is first to be seen. From then on it is rendered all the time and decides itself. @param fetch imports it */
export function laterOnce<P extends object>(
  isSeen: (session: Session) => boolean,
  fetch: () => Promise<ComponentType<P>>,
): ComponentType<P> {
  const part = later(fetch);
  return (given) => {
    const isWanted = useSession(isSeen);
    const [wasWanted, setWasWanted] = useState(isWanted);
    if (isWanted && !wasWanted) setWasWanted(true);
    return wasWanted ? <Panel part={part} given={given} isSeen={false} /> : null;
  };
}

/** A dialog that is open for as long as it is rendered. @param fetch imports it */
export function laterDialog<P extends { readonly onClose: () => void }>(
  fetch: () => Promise<ComponentType<P>>,
): ComponentType<P> {
  const part = later(fetch);
  return (given) => <Cover part={part} given={given} isWanted close={given.onClose} />;
}

/**
 * What covers the page: dialogs, views and screens. Once it is there, it is rendered all the time and decides itself.
 * @param isOpen whether it is to be seen
 * @param fetch imports it
 * @param closed what closes it
 */
export function laterCover(
  isOpen: (session: Session) => boolean,
  fetch: () => Promise<ComponentType<object>>,
  closed: Partial<Session> = { overlay: null },
): ComponentType {
  const part = later(fetch);
  return () => {
    const { session } = useEditor();
    const close = useCallback(() => session.setState(closed), [session]);
    return <Cover part={part} given={{}} isWanted={useSession(isOpen)} close={close} />;
  };
}
