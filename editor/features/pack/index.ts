export { PackView } from './PackView.tsx';
export { packCommands } from './pack-commands.ts';
