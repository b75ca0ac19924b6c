import type { Feature } from '../feature.ts';
import { PackView } from './PackView.tsx';
import { packCommands } from './pack-commands.ts';

/** All levels as cards, in the order in which they are played. */
export const pack: Feature = { name: 'pack', dialogs: PackView, commands: packCommands };
