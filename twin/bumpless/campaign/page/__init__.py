"""One page about a campaign that needs nothing but itself: no network, no script."""

from bumpless.campaign.page.page import page_of

__all__ = ["page_of"]
