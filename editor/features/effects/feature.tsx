import { Puzzle } from 'lucide-react';
import { laterPanel } from '../../core/panel/index.ts';
import type { Feature } from '../feature.ts';
import './effects.css';

/** Which effects the level calls for, and what each costs. */
export const effects: Feature = {
  name: 'effects',
  panel: {
    id: 'effects',
    title: 'Effects',
    icon: <Puzzle size={17} />,
    side: 'right',
    place: 'tab',
    content: laterPanel(() => import('./Effects.tsx').then(({ Effects }) => Effects)),
  },
};
