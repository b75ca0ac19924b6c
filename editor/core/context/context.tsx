import { type ComponentType, createContext, Fragment, type ReactNode, useContext, useRef } from 'react';
import { useStore } from 'zustand';
import type { FolderTerms } from '../../../schema/index.ts';
import { useAtRest, useInPace } from '../ask/index.ts';
import type { DocumentState, ObjectKey } from '../document/index.ts';
import { folderTermsIn } from '../files/index.ts';
import type { LiveProof } from '../proof/index.ts';
import type { Session } from '../session/index.ts';
import type { PageTerms } from '../terms/index.ts';
import type { Editor, OpenLevel } from './editor.ts';

export const EditorContext = createContext<Editor | null>(null);
export const LevelContext = createContext<OpenLevel | null>(null);

/** The editor around this component. */
export function useEditor(): Editor {
  const editor = useContext(EditorContext);
  if (editor === null) throw new Error('expected to be inside an EditorContext');
  return editor;
}

/** The open level around this component. */
export function useLevel(): OpenLevel {
  const level = useContext(LevelContext);
  if (level === null) throw new Error('expected to be inside a LevelContext');
  return level;
}

/** Part of the session; re-renders when it changes. */
export function useSession<T>(pick: (session: Session) => T): T {
  return useStore(useEditor().session, pick);
}

/** What a dialog needs that is open while one of these overlays is. */
export function useOverlay(...names: readonly Session['overlay'][]) {
  const { session } = useEditor();
  return { open: useSession(({ overlay }) => names.includes(overlay)), onClose: () => session.setState({ overlay: null }) };
}

/** Under which terms levels are judged and shown; re-renders when they change. */
export const usePageTerms = (): PageTerms => useStore(useEditor().terms);

/** What the folder's configuration sets; re-renders when it changes. */
export const useFolderTerms = (): FolderTerms => useStore(useEditor().workspace.store, folderTermsIn);

/** Part of the document; re-renders when it changes. */
export function useDocument<T>(pick: (state: DocumentState) => T): T {
  return useStore(useLevel().document.store, pick);
}

/** The keys of the selection; re-renders when they change. */
export function useSelectedKeys(): readonly ObjectKey[] {
  return useStore(useLevel().selection.store, ({ keys }) => keys);
}

/**
 * Part of the live proof; re-renders when it changes. It should be small, as the proof changes with every move of the pointer.
 */
export function useProof<T>(pick: (proof: LiveProof) => T): T {
  return useStore(useLevel().proof.store, pick);
}

/**
 * A value derived from the live proof, updated at most once per `ms`: a panel need not render for every move of the pointer.
 * @param pick stable between renders (`useCallback`, or defined outside the component)
 */
export const useProofInPace = <T,>(pick: (proof: LiveProof) => T, ms = 100): T => useInPace(useLevel().proof.store, pick, ms);

/**
 * A value derived from the live proof once nothing has changed for `ms`, for values too costly during a drag.
 * @param pick stable between renders (defined outside the component)
 */
export const useProofAtRest = <T,>(pick: (proof: LiveProof) => T, ms: number): T => useAtRest(useLevel().proof.store, pick, ms);

/**
 * A number that changes whenever another level is opened, whatever its file is called: a React key for state that belongs to
 * one level.
 */
export function useLevelKey(): number {
  const level = useLevel();
  const opening = useRef({ level, number: 0 });
  if (opening.current.level !== level) opening.current = { level, number: opening.current.number + 1 };
  return opening.current.number;
}

/** Resets its children with every level: scroll positions, folded parts, unfinished input. */
export function PerLevel({ children }: { readonly children: ReactNode }) {
  return <Fragment key={useLevelKey()}>{children}</Fragment>;
}

/** A component that is reset with every level. */
export const perLevel = (Part: ComponentType) => () => (
  <PerLevel>
    <Part />
  </PerLevel>
);

/**
 * Something that belongs to an open level: made on first use, closed when another level is opened.
 * @param make is called once for each opened level
 */
export function ofLevel<T extends { close(): void }>(
  make: (editor: Editor, level: OpenLevel) => T,
): (editor: Editor, level: OpenLevel) => T {
  const known = new WeakMap<OpenLevel, T>();
  return (editor, level) => {
    const there = known.get(level);
    if (there !== undefined) return there;
    const made = make(editor, level);
    known.set(level, made);
    const stop = editor.open.subscribe((current) => {
      if (current === level) return;
      stop();
      known.delete(level);
      made.close();
    });
    return made;
  };
}
