import type { Feature } from '../feature.ts';
import { Tour } from './Tour.tsx';
import './tour.css';

/** A tour of the whole editor in under a minute. */
export const tour: Feature = {
  name: 'tour',
  dialogs: Tour,
  commands: ({ session }) => [
    { id: 'help.tour', title: 'Take the tour', group: 'Help', run: () => session.setState({ overlay: 'tour' }) },
  ],
};
