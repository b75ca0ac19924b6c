import { createContext, useContext } from 'react';
import { useStore } from 'zustand';
import type { FolderRules } from '../../schema/index.ts';
import type { DocumentState, ObjectKey } from '../document/index.ts';
import { folderRulesIn } from '../files/index.ts';
import type { LiveProof } from '../proof/index.ts';
import type { Session } from '../session/index.ts';
import type { Editor, OpenLevel } from './editor.ts';

export const EditorContext = createContext<Editor | null>(null);
export const LevelContext = createContext<OpenLevel | null>(null);

/** The editor around this component. */
export function useEditor(): Editor {
  const editor = useContext(EditorContext);
  if (editor === null) throw new Error('expected to be inside an EditorContext');
  return editor;
}

/** The level that is open around this component. */
export function useLevel(): OpenLevel {
  const level = useContext(LevelContext);
  if (level === null) throw new Error('expected to be inside a LevelContext');
  return level;
}

/** Part of the session; the component follows it. */
export function useSession<T>(pick: (session: Session) => T): T {
  return useStore(useEditor().session, pick);
}

/** The rules that the configuration of the folder sets; the component follows them. */
export const useFolderRules = (): FolderRules => useStore(useEditor().workspace.store, folderRulesIn);

/** Part of the document; the component follows it. */
export function useDocument<T>(pick: (state: DocumentState) => T): T {
  return useStore(useLevel().document.store, pick);
}

/** Keys of what is selected; the component follows them. */
export function useSelectedKeys(): readonly ObjectKey[] {
  return useStore(useLevel().selection.store, ({ keys }) => keys);
}

/** Part of the live proof; the component follows it. What is picked should be small: the proof is new after every move of the pointer. */
export function useProof<T>(pick: (proof: LiveProof) => T): T {
  return useStore(useLevel().proof.store, pick);
}
