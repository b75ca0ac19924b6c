import { Puzzle } from 'lucide-react';
import type { Feature } from '../feature.ts';
import { Effects } from './Effects.tsx';

/** Which effects the level calls for, and what each costs. */
export const effects: Feature = {
  name: 'effects',
  panel: {
    id: 'effects',
    title: 'Effects',
    icon: <Puzzle size={17} />,
    side: 'right',
    place: 'tab',
    content: Effects,
  },
};
