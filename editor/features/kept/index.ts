export { KeptDialog } from './KeptDialog.tsx';
export { tellKept } from './tell-kept.ts';
