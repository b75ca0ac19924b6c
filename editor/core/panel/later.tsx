import { type ComponentType, useEffect } from 'react';
import { useStore } from 'zustand';
import { createStore, type StoreApi } from 'zustand/vanilla';
import { type Editor, useEditor, useSession } from '../context/index.ts';
import type { Session } from '../session/index.ts';
import { Button, Dialog } from '../ui/index.ts';

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

/** Loads all parts, one after another. One that can't be loaded is tried again when it is wanted. */
export async function loadParts(): Promise<void> {
  for (const load of parts) await load(true);
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

function Panel<P extends object>({ part, given }: { readonly part: Later<P>; readonly given: P }) {
  const { store, load } = part;
  const { component: There, hasFailed } = useStore(store);
  useEffect(() => void load(), [load]);
  if (There !== null) return <There {...given} />;
  if (!hasFailed) return null;
  return (
    <div className="panel__body" role="alert">
      <p>{WHY}</p>
      <p>{REMEDY}</p>
      <Again load={load} />
    </div>
  );
}

interface CoverProps {
  readonly part: Later<object>;
  readonly isOpen: (session: Session) => boolean;
  readonly closed: Partial<Session>;
}

function Cover({ part: { store, load }, isOpen, closed }: CoverProps) {
  const { session } = useEditor();
  const isWanted = useSession(isOpen);
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
      if (event.key === 'Escape') session.setState(closed);
    };
    window.addEventListener('keydown', keep, { capture: true });
    return () => window.removeEventListener('keydown', keep, { capture: true });
  }, [isComing, session, closed]);
  if (There !== null) return <There />;
  return (
    <Dialog open={isWanted && hasFailed} title="Not loaded" about={WHY} onClose={() => session.setState(closed)}>
      <p>{REMEDY}</p>
      <Again load={load} />
    </Dialog>
  );
}

/** A panel, or another part that is wanted as soon as it is rendered. @param fetch imports it */
export function laterPanel<P extends object>(fetch: () => Promise<ComponentType<P>>): ComponentType<P> {
  const part = later(fetch);
  return (given) => <Panel part={part} given={given} />;
}

/**
 * What covers the page: dialogs, views and screens. Once it is there, it is rendered all the time and decides itself.
 * @param isOpen whether it is to be seen
 * @param fetch imports it
 * @param closed what closes it
 */
export function laterCover(
  isOpen: CoverProps['isOpen'],
  fetch: () => Promise<ComponentType<object>>,
  closed: CoverProps['closed'] = { overlay: null },
): ComponentType {
  const part = later(fetch);
  return () => <Cover {...{ part, isOpen, closed }} />;
}
