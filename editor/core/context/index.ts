export {
  EditorContext,
  LevelContext,
  ofLevel,
  PerLevel,
  perLevel,
  useDocument,
  useEditor,
  useFolderTerms,
  useLevel,
  useLevelKey,
  usePageTerms,
  useProof,
  useProofAtRest,
  useProofInPace,
  useSelectedKeys,
  useSession,
} from './context.tsx';
export { FINGER, IS_MAC, mediaOf, useCoarse, useMedia, usePageTheme, useTouch } from './device.ts';
export { type Analysis, attemptGhosts, type Editor, type Ghost, type OpenLevel, type Pose, putGhosts } from './editor.ts';
