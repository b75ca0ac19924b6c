export { DropZone } from './DropZone.tsx';
export { LinkDialog } from './LinkDialog.tsx';
export { ShareDialog } from './ShareDialog.tsx';
export { followLinks } from './take-link.ts';
