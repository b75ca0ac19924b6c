export { TextDialog } from './TextDialog.tsx';
