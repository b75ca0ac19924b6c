export {
  EditorContext,
  LevelContext,
  useDocument,
  useEditor,
  useFolderTerms,
  useLevel,
  usePageTerms,
  useProof,
  useProofAtRest,
  useProofInPace,
  useSelectedKeys,
  useSession,
} from './context.ts';
export type { Analysis, Editor, OpenLevel } from './editor.ts';
export { attemptGhosts, type Ghost, putGhosts } from './ghost.ts';
export { ofLevel } from './of-level.ts';
export { PerLevel, perLevel, useLevelKey } from './PerLevel.tsx';
export { usePageTheme } from './page-theme.ts';
export { IS_MAC } from './platform.ts';
export type { Pose } from './pose.ts';
export { useTouch } from './use-touch.ts';
