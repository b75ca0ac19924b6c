import { ListTree } from 'lucide-react';
import { perLevel } from '../../core/context/index.ts';
import type { Feature } from '../feature.ts';
import { Outliner } from './Outliner.tsx';
import { objectDestinations } from './object-destinations.ts';

/** All objects of the level as a tree. */
export const outliner: Feature = {
  name: 'outliner',
  panel: {
    id: 'outline',
    title: 'Outline',
    icon: <ListTree size={17} />,
    side: 'left',
    place: 'tab',
    content: perLevel(Outliner),
  },
  destinations: objectDestinations,
};
