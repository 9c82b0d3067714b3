! umpc_user, a user MPC of CalculiX: SLIDER, which keeps node m on the line through nodes 1
! and n.
!
! *MPC     with USER and the nodes m, m, 1, 1, 1, n, n, n in space, twice, since each
!          eliminates one coordinate of m; m, m, 1, 1, n, n in the plane of the first two
!          axes, once
! JDOF     the degrees of freedom of the terms: first the one that is eliminated, then the
!          one of m that is kept
! F        by how much the eliminated coordinate is off the line
! A        the coefficients of the linearised constraint, in the order of JDOF
! IDISCON  1 where another coordinate is eliminated than before, since the line has turned
!
! CalculiX as it is refuses two user MPCs that begin with the same node, and has one routine
! umpc_user: this one takes the place of its own, and its usermpc.f has to give the second
! MPC of a node the second degree of freedom. In a model in the plane nodes are in space,
! with elements like C3D8: those like CPE4 are expanded, and the line is not held. Nothing
! else may prescribe or eliminate a coordinate of m.
!
! Put together from formulas that jointproof proves; free of conditions (CC0-1.0). Compile
! with -ffp-contract=off.
subroutine umpc_user(x, u, f, a, jdof, n, force, iit, idiscon)
{uses}    use jp_runtime, only: dp
    implicit none
    integer, intent(in) :: n, iit
    integer, intent(inout) :: jdof(*), idiscon
    real(dp), intent(in) :: x(3, *), u(3, *), force
    real(dp), intent(inout) :: f, a(*)
    real(dp) :: x1(3), xn(3), d(3), xm, found(2), slope(2, 7)
    integer :: dim, axes(3), more, less, eliminated, kept, row, code, k

    dim = n / 2 - 1
    if (n /= 2 * dim + 2 .or. (dim /= 2 .and. dim /= 3)) &
        error stop 'umpc_user: 8 nodes in space, 6 in the plane'
    x1 = x(:, 3) + u(:, 3)
    xn = x(:, 3 + dim) + u(:, 3 + dim)
    ! The axes as the formulas choose them: those that are eliminated, then the one that is
    ! kept.
    {axes}
    if (dim == 2) axes(:2) = merge([2, 1], [1, 2], d(1) >= d(2))
    ! At first the last axis is kept. Of both MPCs the one that eliminates what is to be
    ! kept goes to what was kept.
    eliminated = jdof(1)
    kept = merge(jdof(2), dim, jdof(2) > 0)
    if (eliminated == kept) error stop 'umpc_user: node m is in another MPC, too'
    if (eliminated == axes(dim)) then
        eliminated = kept
        idiscon = 1
    end if
    kept = axes(dim)
    row = merge(1, 2, eliminated == axes(1))
    xm = x(kept, 1) + u(kept, 1)
    slope = 0
    if (dim == 2) then
        code = jp_slider_eliminate_2d_jacobian(x1(:2), xn(:2), xm, found(1), slope(1:1, 1:5))
    else
        code = jp_slider_eliminate_jacobian(x1, xn, xm, found(1), found(2), slope)
    end if
    if (code /= 0) error stop 'umpc_user: nodes 1 and n coincide'
    f = x(eliminated, 1) + u(eliminated, 1) - found(row)
    a(1:n) = [1.0_dp, -slope(row, 2 * dim + 1), -slope(row, :2 * dim)]
    jdof(1:n) = [eliminated, kept, (k, k=1, dim), (k, k=1, dim)]
end subroutine umpc_user
