import { SlidersHorizontal } from 'lucide-react';
import { perLevel } from '../../core/context/index.ts';
import type { Feature } from '../feature.ts';
import { Inspector } from './Inspector.tsx';
import { ruleCommands, ruleDestinations } from './rule-commands.ts';

/** The numbers of what is selected, or of the level and its rules. */
export const inspector: Feature = {
  name: 'inspector',
  panel: {
    id: 'inspector',
    title: 'Inspector',
    icon: <SlidersHorizontal size={17} />,
    side: 'right',
    place: 'tab',
    content: perLevel(Inspector),
  },
  commands: ruleCommands,
  destinations: ruleDestinations,
};
