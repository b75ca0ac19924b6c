export { Offer } from './Offer.tsx';
