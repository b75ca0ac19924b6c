import { TriangleAlert } from 'lucide-react';
import { perLevel } from '../../core/context/index.ts';
import type { Feature } from '../feature.ts';
import { Problems } from './Problems.tsx';

/** What is wrong with the level, and how to mend it. */
export const problems: Feature = {
  name: 'problems',
  panel: {
    id: 'problems',
    title: 'Problems',
    icon: <TriangleAlert size={17} />,
    side: 'right',
    place: 'fixed',
    content: perLevel(Problems),
  },
};
